#pragma once
// The flight of one ball between two collisions, and what can be said of it in closed form.

#include <cstdint>

#include "carom/observe/subject.hpp"

namespace carom {

/// The part of a flight that was measured, 0 <= s <= duration: v(s) = velocity + s acceleration, or velocity turned by
/// s magnetic.
struct Flight {
  std::uint32_t ball = 0;
  double mass = 1.0;
  Triple velocity{};      ///< at its beginning, or where measuring begins
  Triple acceleration{};  ///< constant
  double begin = 0.0;     ///< [time] since measuring began
  double end = 0.0;       ///< [time] since measuring began
  double duration = 0.0;  ///< end - begin, rounded once
  bool hit = true;        ///< it ended in a collision; false: measuring ended
  double magnetic = 0.0;  ///< [rad/time] rate at which the velocity turns; then there is no acceleration
  Triple departure{}, arrival{};  ///< [length] where it begins and ends, not wrapped

  /// Length of the path, to a few ulp:
  ///   (1/g) int sqrt(q^2 + w^2) dw,  w from w0 to w0 + g t,
  /// with g = |a|, w0 the speed along a at the beginning and q the speed across it. No term cancels.
  [[nodiscard]] double path() const;

  /// int |v|^2 ds and int |v|^4 ds.
  [[nodiscard]] double square() const;
  [[nodiscard]] double fourth() const;

  /// Time spent at speeds below `speed`.
  [[nodiscard]] double time_below(double speed) const;

  /// The highest speed reached: at one of the ends, since |v|^2 is convex.
  [[nodiscard]] double top_speed() const;
};

}  // namespace carom
