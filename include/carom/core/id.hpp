#pragma once
// Names of things: a ball's number and a wall's number are not interchangeable and have no arithmetic.

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>

namespace carom {

enum class BallId : std::uint32_t {};
enum class WallId : std::uint32_t {};

[[nodiscard]] constexpr std::uint32_t index(BallId id) noexcept { return static_cast<std::uint32_t>(id); }
[[nodiscard]] constexpr std::uint32_t index(WallId id) noexcept { return static_cast<std::uint32_t>(id); }
[[nodiscard]] constexpr BallId ball_id(std::size_t i) noexcept { return static_cast<BallId>(i); }
[[nodiscard]] constexpr WallId wall_id(std::size_t i) noexcept { return static_cast<WallId>(i); }

/// Counts of periods, relative to stored wrapped positions. Zero where the space is not periodic.
template <int D>
struct Image {
  std::array<std::int32_t, static_cast<std::size_t>(D)> turns{};

  [[nodiscard]] constexpr std::int32_t& operator[](int k) noexcept { return turns[static_cast<std::size_t>(k)]; }
  [[nodiscard]] constexpr std::int32_t operator[](int k) const noexcept { return turns[static_cast<std::size_t>(k)]; }
  [[nodiscard]] constexpr Image operator-() const noexcept {
    Image back;
    for (int k = 0; k < D; ++k) back[k] = -(*this)[k];
    return back;
  }
  friend constexpr bool operator==(const Image& a, const Image& b) noexcept {
    bool same = true;  // the default one is a call of memcmp
    for (int k = 0; k < D; ++k) same = same && a[k] == b[k];
    return same;
  }
  friend constexpr auto operator<=>(const Image&, const Image&) = default;
};

}  // namespace carom
