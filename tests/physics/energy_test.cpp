// Energy over long runs: how small the error is, and that it has no direction.

#include <gtest/gtest.h>

#include "carom/motion/free_flight.hpp"
#include "carom/queue/heap_queue.hpp"
#include "carom/search/all_pairs.hpp"
#include "carom/sim/event_driven.hpp"
#include "carom/sim/totals.hpp"
#include "carom/world/build.hpp"
#include "sim/scenes.hpp"

namespace carom {
namespace {

using namespace testing;

TEST(Energy, five_unequal_balls_in_a_box_for_ten_million_collisions) {
  const Scene scene = mixed_box(2, 5, 10.0, 2026);
  Simulation simulation(scene);
  const std::int64_t collisions = scaled_count(10'000'000);
  for (int part = 0; part < 10; ++part) {
    ASSERT_EQ(simulation.advance(std::nullopt, collisions / 10), Stop::events);
    EXPECT_LE(simulation.summary().energy.relative_error, 5e-13) << "after " << simulation.counts().collisions();
  }
  EXPECT_EQ(simulation.counts().collisions(), collisions);
  EXPECT_EQ(simulation.summary().exactness.clamped, 0);
  EXPECT_EQ(simulation.audit(AuditBy::every_pair).overlaps, 0);
}

// The signed relative error of a run, in double-double: it is far below an ulp of the energy at first.
class Walk {
 public:
  explicit Walk(const Scene& scene)
      : world_(build<double, 2>(scene)),
        engine_(world_, Flight{}),
        start_(totals_at(Flight{}, world_, world_.start).kinetic) {}

  double after(std::int64_t collisions) {
    engine_.advance(Time<double>::never(), collisions, NoSink{});
    const Wide<double> now = totals_at(Flight{}, world_, engine_.now()).kinetic;
    return narrow(now - start_) / narrow(start_);
  }

 private:
  using Flight = FreeFlight<double, 2>;
  World<double, 2> world_;
  EventDriven<Flight, AllPairs<double, 2>, HeapQueue<double, 2>> engine_;
  Wide<double> start_;
};

// Twenty seeds, a million collisions each. Were there a bias, the errors would grow with n and share a sign; a walk of
// independent roundings ends at random with mean 0, and its regression slope over the run is as often up as down.
TEST(Energy, the_error_has_no_slope) {
  constexpr int seeds = 20, parts = 25;
  const std::int64_t collisions = scaled_count(1'000'000);
  double sum = 0, squares = 0, slopes = 0, slope_squares = 0;
  for (int seed = 0; seed < seeds; ++seed) {
    Walk walk(mixed_box(2, 5, 10.0, 100 + std::uint64_t(seed)));
    double error = 0, covariance = 0, variance = 0;
    for (int part = 1; part <= parts; ++part) {
      error = walk.after(collisions / parts);
      covariance += part * error;  // through the origin, where the error is 0
      variance += double(part) * part;
    }
    const double slope = covariance / variance;
    sum += error;
    squares += error * error;
    slopes += slope;
    slope_squares += slope * slope;
    EXPECT_LE(std::abs(error), 5e-13) << "seed " << seed;
  }
  // Under the null both sums are normal with the variance of their terms: 4 s.e. is passed once in 16000.
  EXPECT_LE(std::abs(sum), 4 * std::sqrt(squares)) << "mean error " << sum / seeds;
  EXPECT_LE(std::abs(slopes), 4 * std::sqrt(slope_squares)) << "mean slope " << slopes / seeds;
  // An unbiased walk: a few 1e-17 sqrt(n). A bias of 1e-18 a collision alone would reach 1e-12.
  EXPECT_LE(std::sqrt(squares / seeds), 1.5e-16 * std::sqrt(double(collisions)));
}

// Elastic on the floor under gravity: each contact time is taken with the gap as it is, so the ball does not wander into
// the floor by a rounding at each bounce, and neither does its energy.
TEST(Energy, a_bouncing_ball_does_not_wander) {
  Scene scene = open_space(2);
  scene.motion.acceleration = {0.0, -9.81};
  scene.walls = {plane({0.0, 0.0}, {0.0, 1.0})};
  scene.balls = {ball({0.0, 1.5}, {0.3, 0.0})};
  Simulation simulation(scene);
  simulation.advance(std::nullopt, 200'000);
  const Summary s = simulation.summary();
  EXPECT_EQ(s.events.ball_wall, 200'000);
  EXPECT_LE(s.exactness.max_gap_error, 4e-15);
  EXPECT_LE(s.energy.relative_error, 1e-14);
}

}  // namespace
}  // namespace carom
