#pragma once
// From a Scene to a World: places what is generated, chooses the units, judges the geometry, finds who starts in contact.

#include "carom/scene/scene.hpp"
#include "carom/world/world.hpp"

namespace carom {

/// Lengths, masses and accelerations may span 2^400 on either side of their unit, speeds 2^800 in all; beyond is an
/// InputError.
inline constexpr int exponent_range = 400;

/// Builds the world of a scene in the arithmetic of Real; D must be the scene's dimension.
/// The epoch length is L = tau 2^-12 rounded to a power of two, with tau = smallest positive length / largest speed that
/// any ball of finite mass could reach with all the kinetic energy of the start, up to 2^20 times the fastest there (or that
/// a fall through the largest length gives) [papers/clock.md, eq. 4]. Balls whose gap to each other or to a wall cannot be told from 0, given half an ulp of doubt in each input,
/// start in contact. Throws InputError with every problem found.
template <class Real, int D>
[[nodiscard]] World<Real, D> build(const Scene& scene);

/// The moment `t` of a scene (user's unit of time) on a clock with epochs of 2^exponent; the exact text counts, rounded
/// once to the grid. `never` beyond the clock.
template <class Real>
[[nodiscard]] Time<Real> clock_time(const Number& t, int exponent);

extern template World<double, 1> build<double, 1>(const Scene&);
extern template World<double, 2> build<double, 2>(const Scene&);
extern template World<double, 3> build<double, 3>(const Scene&);
extern template Time<double> clock_time<double>(const Number&, int);

}  // namespace carom
