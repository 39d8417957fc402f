#pragma once
// An approximate periodic orbit, made as exact as wanted, and how stable it is.

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "carom/core/precision.hpp"
#include "carom/scene/scene.hpp"
#include "carom/sim/simulation.hpp"

namespace carom {

/// No orbit was found from this start (exit status 3): why, and what to do.
class OrbitError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Of what lies beside the orbit, within its surface of energy: all multipliers of size 1 and some not +-1; all +-1; else.
enum class OrbitKind : std::uint8_t { elliptic, parabolic, hyperbolic };

struct OrbitPoint {
  Number time;                   ///< [time] from the start
  EventKind kind = EventKind::ball_wall;
  std::uint32_t ball = 0, partner = 0;  ///< ball_wall: partner is a wall
  std::int32_t feature = 0;      ///< of the wall
  std::vector<Number> position;  ///< [length] of the ball's centre, not wrapped
};

struct Multiplier {
  Number real, imaginary;
};

struct PeriodicOrbit {
  std::vector<BallState> start;    ///< the balls that move, next to the start of the scene where that is in flight
  Number period;                   ///< [time]
  Number length;                   ///< [length] of all paths together; NaN under an acceleration
  Number residual;                 ///< largest difference of a coordinate or a velocity after one period, in the scene's units
  std::vector<std::vector<std::int64_t>> shift;  ///< periods of the space that each of them has gone on
  std::vector<OrbitPoint> points;  ///< one a collision
  std::int64_t prime = 0;          ///< collisions after which it is at its start already
  std::vector<Multiplier> multipliers;  ///< eigenvalues of the return map across the orbit, largest first
  Number trace;                    ///< of that map
  OrbitKind kind = OrbitKind::hyperbolic;
  int iterations = 0;
  std::string arithmetic;          ///< "84 digits", or "double"
};

/// The orbit of `collisions` collisions next to the start of the scene, by Newton's method (after Levenberg and Marquardt
/// [YamashitaFukushima2001]: orbits that come in families are found, too) on the state after one period; the energy stays,
/// and so does the sequence of who meets whom. In a periodic space the orbit may end a lattice vector from its start.
///
/// Derivatives are central differences in three times the digits of `precision` (double: 17), so what is reported is right
/// to about as many as it has: the error of a difference is below 10^-2n of it. Scenes that can be moved in double alone
/// are refined in double, with multipliers to some 8 digits [papers/periodic_orbits.md].
///
/// Throws InputError if nothing in the scene can be periodic (balls that are not written out, dissipation, moving walls),
/// OrbitError if no orbit with the sequence of the start was found.
[[nodiscard]] PeriodicOrbit refine_orbit(const Scene& scene, std::int64_t collisions, const Precision& precision = {});

[[nodiscard]] std::string_view word(OrbitKind kind) noexcept;

}  // namespace carom
