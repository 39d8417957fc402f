#pragma once
// The first flights of a run, read back from the first chunk of its log.

#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "write/json_text.hpp"

namespace carom::app {

using Point = std::array<double, 3>;

/// x + v s + a s^2 / 2, s after `time`; in a magnetic field a circle.
struct Flight {
  double time;
  Point x{}, v{}, a{};
  double radius;        ///< NaN: gone
  double magnetic = 0;  ///< cyclotron frequency

  [[nodiscard]] Point at(double t) const {
    const double s = t - time;
    if (magnetic != 0) {
      const double half = magnetic * s / 2, size = 2 * std::sin(half) / magnetic, c = std::cos(half), d = std::sin(half);
      return {x[0] + size * (c * v[0] - d * v[1]), x[1] + size * (c * v[1] + d * v[0]), 0};
    }
    Point p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = x[k] + s * (v[k] + s * a[k] / 2);
    return p;
  }
};

/// Every ball's flights from the start, as far as they are drawn.
struct Paths {
  std::vector<std::vector<Flight>> of;
  double start = 0;         ///< [time]
  double now = 0;           ///< [time] the moment of the picture
  Point period{}, lower{};  ///< [length] of a periodic space; period 0 where there is none

  [[nodiscard]] const Flight& flight(std::size_t ball) const { return of[ball].back(); }
};

/// `scene` and `start` as the page gets them, `chunk` the first of the log (empty: nothing happened), `end` the run's last
/// moment.
[[nodiscard]] Paths paths_of(const Json& scene, std::string_view start, std::string_view chunk, double end);

}  // namespace carom::app
