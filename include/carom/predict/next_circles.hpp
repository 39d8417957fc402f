#pragma once
// Which circles a ball comes to first that leaves one of them, in a plane where each stands in every period.

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "carom/core/lanes.hpp"
#include "carom/core/vec.hpp"
#include "carom/shape/sphere.hpp"
#include "carom/world/world.hpp"

namespace carom {

/// Four circles as they stand, and how far they can be trusted to be all.
struct alignas(32) FourCircles {
  double x[lanes], y[lanes];  ///< [length unit] centres
  double sigma[lanes];        ///< [length unit] distance of a ball's centre at contact
  double within = 0;  ///< [length unit^2] square of a way on which no circles are met but these and those before
  std::uint16_t row[lanes] = {};  ///< of the circles that the table was made from
  std::int16_t image[lanes][2] = {};
};
static_assert(sizeof(FourCircles) == 128);

/// Where four circles stand beside where the scene puts them.
struct alignas(32) FourShifts {
  double x[lanes] = {}, y[lanes] = {};  ///< [length unit] whole periods, rounded
};

/// For each circle, and each of 32 sectors of the direction in which a ball leaves it: the circles that the ball may meet,
/// the nearest first, each where it stands. Which of them it does meet is decided by its contact times; a path that leads on
/// beyond the list is for others to follow.
///
/// A ball that leaves a circle of reach s about 0 meets one of reach q about D only if D is within s + q of the cone of
/// directions, and flies at least |D| - s - q before.
class NextCircles {
 public:
  static constexpr std::size_t most_circles = 64;  ///< of more there are no lists

  /// walls: centres as walls stand, rounded once. balls: centres as the scene puts them, and shifts beside them.
  enum class Of : std::uint8_t { walls, balls };

  /// The circles that balls of this radius meet from outside, in a periodic space.
  NextCircles(const Space<double, 2>& space, const std::vector<Sphere<double, 2>>& circles, double radius, Of of);

  struct Range {
    const FourCircles *begin, *end;
    const FourShifts* shift;  ///< balls: that of the first
  };
  /// After leaving circle `row`, as it stands in period `image` relative to a ball stored within the cell.
  [[nodiscard]] CAROM_INLINE Range from(std::uint32_t row, const Image<2>& image, const Vec<double, 2>& v) const {
    if (row >= lowest_.size()) return {nullptr, nullptr, nullptr};
    const std::uint32_t x = static_cast<std::uint32_t>(image[0] - lowest_[row][0]),
                        y = static_cast<std::uint32_t>(image[1] - lowest_[row][1]);
    if (x > 2 || y > 2) return {nullptr, nullptr, nullptr};
    const std::uint32_t list = lists_[row * 9 + y * 3 + x];
    if (list == no_list) return {nullptr, nullptr, nullptr};
    const std::uint32_t at = list + sector(v[0], v[1]) * depth;
    return {fours_.data() + at, fours_.data() + at + depth, shifts_.data() + at};
  }

  /// Of the direction of (x, y): by octants, each split where the tangent of the angle to the nearest axis is 1/4, 1/2, 3/4.
  [[nodiscard]] CAROM_INLINE static std::uint32_t sector(double x, double y) {
    const double ax = std::fabs(x), ay = std::fabs(y), low = ax < ay ? ax : ay, high = ax < ay ? ay : ax;
    const std::uint32_t octant = static_cast<std::uint32_t>(x < 0) | static_cast<std::uint32_t>(y < 0) << 1 |
                                 static_cast<std::uint32_t>(ax < ay) << 2;
    return octant * 4 + static_cast<std::uint32_t>(4 * low > high) + static_cast<std::uint32_t>(2 * low > high) +
           static_cast<std::uint32_t>(4 * low > 3 * high);
  }

 private:
  static constexpr std::uint32_t depth = 6;  ///< groups of four in a list
  static constexpr std::uint32_t sectors = 32;
  static constexpr std::uint32_t no_list = ~std::uint32_t{0};

  std::vector<std::array<std::int32_t, 2>> lowest_;  // by row: the first of the three periods an axis that a list is kept for
  std::vector<std::uint32_t> lists_;                 // by row and period: the first of `sectors` lists
  std::vector<FourCircles> fours_;
  std::vector<FourShifts> shifts_;  // of balls
};

}  // namespace carom
