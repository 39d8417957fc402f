#pragma once
// Vectors whose memory is asked of the operating system and given back to it at once: for arrays of millions that live for a
// while only. (What the heap gets back it may keep, or have cut into pieces too small for the next.)

#include <cstddef>
#include <new>
#include <vector>

namespace carom {

namespace detail {
/// Pages as in core/pages.hpp.
[[nodiscard]] void* take_pages(std::size_t bytes);
void give_back_pages(void* data, std::size_t bytes);
}  // namespace detail

/// Takes pages from 1 MiB on, and the heap's memory below.
template <class T>
struct PageAllocator {
  using value_type = T;
  static constexpr std::size_t least = std::size_t{1} << 20;

  PageAllocator() = default;
  template <class U>
  PageAllocator(const PageAllocator<U>&) noexcept {}

  [[nodiscard]] T* allocate(std::size_t n) {
    if (n > static_cast<std::size_t>(-1) / 2 / sizeof(T)) throw std::bad_array_new_length();
    const std::size_t bytes = n * sizeof(T);
    return static_cast<T*>(bytes < least ? ::operator new(bytes) : detail::take_pages(bytes));
  }
  void deallocate(T* data, std::size_t n) noexcept {
    if (n * sizeof(T) < least) {
      ::operator delete(data);
    } else {
      detail::give_back_pages(data, n * sizeof(T));
    }
  }
  friend bool operator==(const PageAllocator&, const PageAllocator&) { return true; }
};

template <class T>
using PageVector = std::vector<T, PageAllocator<T>>;

/// Takes the memory from a vector. (Assigning {} leaves it where it is.)
template <class Vector>
void give_back(Vector& v) {
  Vector().swap(v);
}

}  // namespace carom
