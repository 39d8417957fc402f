#pragma once
// Runs that are watched: after every few collisions all pairs and walls are audited, and at the end the books.

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "carom/core/error.hpp"
#include "sim/scenes.hpp"

namespace carom::testing {

struct Watch {
  std::int64_t events = std::numeric_limits<std::int64_t>::max();  ///< run through so many collisions,
  std::optional<double> until{};                                   ///< or to this time, whichever comes first
  std::int64_t stride = 1;                                         ///< collisions between two audits
  double energy_error = 4e-15;                                     ///< largest relative error of the energy balance
};

/// Runs the scene. Expects that no event was found in the past, that nothing overlaps at any of the audits, and that the
/// energy balance holds.
inline Result watched_run(const Scene& scene, const Watch& watch) {
  Result result;
  Simulation simulation(scene);
  const std::optional<Number> until = watch.until ? std::optional<Number>(*watch.until) : std::nullopt;
  for (std::int64_t left = watch.events; left > 0; left -= watch.stride) {
    result.stop =
        simulation.advance(until, std::min(left, watch.stride), [&](const Collision& c) { result.log.push_back(c); });
    const Audit truth = simulation.audit(AuditBy::every_pair);
    EXPECT_EQ(truth.overlaps, 0) << "ball " << truth.ball << " and " << (truth.with_wall ? "wall " : "ball ")
                                 << truth.partner << " by " << truth.deepest << " after collision " << result.log.size();
    if (truth.overlaps != 0 || result.stop != Stop::events) break;
  }
  result.summary = simulation.summary();
  result.balls = simulation.balls();
  EXPECT_EQ(result.summary.exactness.clamped, 0);
  EXPECT_LE(result.summary.energy.relative_error, watch.energy_error);
  return result;
}

[[nodiscard]] inline WallSpec polygon(std::vector<Coordinates> vertices) {
  WallSpec w;
  w.kind = WallKind::polygon;
  w.vertices = std::move(vertices);
  return w;
}

[[nodiscard]] inline BallSpec fixed_ball(Coordinates x, double radius = 0.5) {
  BallSpec b = ball(std::move(x), {}, radius);
  b.fixed = true;
  return b;
}

[[nodiscard]] inline double speed_of(const BallState& b) {
  double s = 0.0;
  for (const double v : b.velocity) s = std::hypot(s, v);
  return s;
}

/// Messages of the problems that a scene is refused with; none if it is taken.
[[nodiscard]] inline std::vector<std::string> refusals(const Scene& scene) {
  std::vector<std::string> texts;
  try {
    (void)Simulation(scene);
  } catch (const InputError& e) {
    for (const Problem& p : e.problems()) texts.push_back(p.text());
  }
  return texts;
}

}  // namespace carom::testing
