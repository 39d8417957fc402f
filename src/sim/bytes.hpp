#pragma once
// Plain bytes in the machine's own order, written and read back; and a fingerprint of them.

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace carom {

/// FNV-1a, 64 bit [Fowler1991].
[[nodiscard]] inline std::uint64_t fingerprint(std::string_view bytes) {
  std::uint64_t h = 0xcbf29ce484222325u;
  for (const char c : bytes) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return h;
}

class ByteWriter {
 public:
  template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  void put(T value) { bytes_.append(reinterpret_cast<const char*>(&value), sizeof value); }
  void put(std::string_view text) {
    put(static_cast<std::uint64_t>(text.size()));
    bytes_.append(text);
  }
  [[nodiscard]] const std::string& bytes() const noexcept { return bytes_; }

 private:
  std::string bytes_;
};

/// Reading past the end, or a count that cannot be, throws std::out_of_range.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  void get(T& value) {
    if (bytes_.size() < sizeof value) throw std::out_of_range("bytes end early");
    if constexpr (std::is_same_v<T, bool>) {
      if (static_cast<unsigned char>(bytes_[0]) > 1) throw std::out_of_range("not a truth value");
    }
    std::memcpy(&value, bytes_.data(), sizeof value);
    bytes_.remove_prefix(sizeof value);
  }
  template <class T>
  [[nodiscard]] T get() {
    T value{};
    get(value);
    return value;
  }
  void get(std::string& text) {
    const std::size_t n = count();
    text = bytes_.substr(0, n);
    bytes_.remove_prefix(n);
  }
  /// A count of things of at least one byte each.
  [[nodiscard]] std::size_t count() {
    const std::uint64_t n = get<std::uint64_t>();
    if (n > bytes_.size()) throw std::out_of_range("a count beyond the bytes");
    return static_cast<std::size_t>(n);
  }
  [[nodiscard]] bool at_end() const noexcept { return bytes_.empty(); }

 private:
  std::string_view bytes_;
};

}  // namespace carom
