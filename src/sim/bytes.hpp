#pragma once
// Plain bytes in the machine's own order, written and read back piece by piece; and a fingerprint of them.

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace carom {

/// FNV-1a, 64 bit [Fowler1991], of bytes that come in pieces.
class Fingerprint {
 public:
  void add(std::string_view bytes) {
    for (const char c : bytes) value_ = (value_ ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  }
  [[nodiscard]] std::uint64_t value() const noexcept { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

/// Bytes of this many at a time are handed on, or asked for.
inline constexpr std::size_t piece_size = std::size_t{1} << 18;

class ByteWriter {
 public:
  /// `sink` gets all bytes in pieces; none: only their fingerprint is wanted.
  explicit ByteWriter(std::function<void(std::string_view)> sink = {}) : sink_(std::move(sink)) {
    piece_.reserve(piece_size + 64);
  }

  template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  void put(T value) { append(reinterpret_cast<const char*>(&value), sizeof value); }
  void put(std::string_view text) {
    put(static_cast<std::uint64_t>(text.size()));
    append(text.data(), text.size());
  }
  /// In one byte if it is small, whatever its sign: seven bits a byte, the last byte below 128.
  void put_whole(std::int64_t value) {
    std::uint64_t rest = (static_cast<std::uint64_t>(value) << 1) ^ static_cast<std::uint64_t>(value >> 63);
    for (; rest >= 128; rest >>= 7) put(static_cast<std::uint8_t>(rest | 128));
    put(static_cast<std::uint8_t>(rest));
  }

  /// Of all bytes until now.
  [[nodiscard]] std::uint64_t fingerprint() {
    flush();
    return print_.value();
  }
  void flush() {
    print_.add(piece_);
    if (sink_ && !piece_.empty()) sink_(piece_);
    piece_.clear();
  }

 private:
  void append(const char* bytes, std::size_t n) {
    piece_.append(bytes, n);
    if (piece_.size() >= piece_size) flush();
  }

  std::function<void(std::string_view)> sink_;
  std::string piece_;
  Fingerprint print_;
};

/// Fills the span with the bytes that begin at a place.
using ByteSource = std::function<void(std::uint64_t, std::span<char>)>;

/// Reading past the end, or a count that cannot be, throws std::out_of_range.
class ByteReader {
 public:
  /// The bytes from `begin` up to `end`; `source` must outlive the reader.
  ByteReader(const ByteSource& source, std::uint64_t begin, std::uint64_t end) : source_(&source), next_(begin), end_(end) {}

  template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  void get(T& value) {
    char bytes[sizeof value];
    take(bytes, sizeof value);
    if constexpr (std::is_same_v<T, bool>) {
      if (static_cast<unsigned char>(bytes[0]) > 1) throw std::out_of_range("not a truth value");
    }
    std::memcpy(&value, bytes, sizeof value);
  }
  template <class T>
  [[nodiscard]] T get() {
    T value{};
    get(value);
    return value;
  }
  void get(std::string& text) {
    text.resize(count());
    take(text.data(), text.size());
  }
  [[nodiscard]] std::int64_t get_whole() {
    std::uint64_t value = 0;
    for (int shift = 0;; shift += 7) {
      const std::uint8_t byte = get<std::uint8_t>();
      if (shift == 63 && byte > 1) throw std::out_of_range("a number beyond 64 bits");
      value |= static_cast<std::uint64_t>(byte & 127) << shift;
      if (byte < 128) break;
    }
    return static_cast<std::int64_t>(value >> 1) ^ -static_cast<std::int64_t>(value & 1);
  }
  /// A count of things of at least one byte each.
  [[nodiscard]] std::size_t count() {
    const std::uint64_t n = get<std::uint64_t>();
    if (n > left()) throw std::out_of_range("a count beyond the bytes");
    return static_cast<std::size_t>(n);
  }
  [[nodiscard]] bool at_end() const noexcept { return left() == 0; }

 private:
  [[nodiscard]] std::uint64_t left() const noexcept { return end_ - next_ + (piece_.size() - used_); }

  void take(char* to, std::size_t n) {
    if (n > left()) throw std::out_of_range("bytes end early");
    while (n > 0) {
      if (used_ == piece_.size()) refill();
      const std::size_t some = std::min(n, piece_.size() - used_);
      std::memcpy(to, piece_.data() + used_, some);
      used_ += some;
      to += some;
      n -= some;
    }
  }
  void refill() {
    piece_.resize(static_cast<std::size_t>(std::min<std::uint64_t>(piece_size, end_ - next_)));
    (*source_)(next_, piece_);
    next_ += piece_.size();
    used_ = 0;
  }

  const ByteSource* source_;
  std::uint64_t next_, end_;  // what has not been asked for yet
  std::vector<char> piece_;
  std::size_t used_ = 0;
};

}  // namespace carom
