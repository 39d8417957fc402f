#pragma once
// Arrays of plain records in memory pages of their own: aligned, huge where the system has huge pages, freed at once.

#include <cstddef>
#include <type_traits>
#include <utility>

#include "carom/core/lanes.hpp"

namespace carom {

/// Pages straight from the operating system, asked to be huge: fewer misses when a million records are visited in any order.
/// Not copied. New bytes are 0, and take no memory before they are touched.
class Pages {
 public:
  Pages() = default;
  explicit Pages(std::size_t bytes);
  Pages(Pages&& other) noexcept : data_(std::exchange(other.data_, nullptr)), bytes_(std::exchange(other.bytes_, 0)) {}
  Pages& operator=(Pages&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(bytes_, other.bytes_);
    return *this;
  }
  Pages(const Pages&) = delete;
  Pages& operator=(const Pages&) = delete;
  ~Pages();

  [[nodiscard]] void* data() const noexcept { return data_; }
  [[nodiscard]] std::size_t bytes() const noexcept { return bytes_; }
  /// Makes room for more; what is there stays.
  void grow(std::size_t bytes);

 private:
  void* data_ = nullptr;
  std::size_t bytes_ = 0;
};

/// An array of trivial records of type T in pages of its own.
template <class T>
class PageArray {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

 public:
  PageArray() = default;
  /// `size` records whose bytes are 0.
  explicit PageArray(std::size_t size) : pages_(size * sizeof(T)), size_(size) {}

  CAROM_INLINE T& operator[](std::size_t i) { return static_cast<T*>(pages_.data())[i]; }
  CAROM_INLINE const T& operator[](std::size_t i) const { return static_cast<const T*>(pages_.data())[i]; }
  CAROM_INLINE T* data() { return static_cast<T*>(pages_.data()); }
  CAROM_INLINE const T* data() const { return static_cast<const T*>(pages_.data()); }
  CAROM_INLINE std::size_t size() const { return size_; }
  CAROM_INLINE void resize(std::size_t size) {
    if (size * sizeof(T) > pages_.bytes()) pages_.grow(2 * size * sizeof(T));
    size_ = size;
  }
  [[nodiscard]] std::size_t bytes() const noexcept { return pages_.bytes(); }

 private:
  Pages pages_;
  std::size_t size_ = 0;
};

}  // namespace carom
