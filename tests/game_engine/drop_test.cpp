// A ball that falls by 2 and bounces at restitution 1: each apex should be at 2 again.

#include <algorithm>
#include <cmath>

#include "engine_runs.hpp"

namespace carom {
namespace {

const std::string drop = R"(
  run.until = 14
  motion.acceleration = [0, -9.81]
  [[ball]]
  position = [0, 2.5]
  [[wall]]
  kind = "plane"
  point = [0, 0]
  normal = [0, 1])";

/// The highest point after each bounce but the last, over the height of the fall.
std::vector<double> bounces(const std::string& engine, double dt, double until) {
  GameEngineOptions options = parse_game_engine(engine);
  options.dt = dt;
  const auto stepper = make_game_engine(test::scene_of(drop), options);
  std::vector<double> tops;
  double top = 0.0;
  int hits = 0;
  while (stepper->time() < until) {
    bool hit = false;
    stepper->step([&](const StepContact& c) { hit = hit || c.impulse > 0; });
    if (hit && hits++ > 0) tops.push_back(top / 2);
    if (hit) top = 0.0;
    top = std::max(top, stepper->balls()[0].position[1] - 0.5);
  }
  return tops;
}

// Fall 0.6386, then one bounce each 1.2771: eleven in 14.
TEST(Drop, is_elastic_in_chipmunk) {
  CAROM_SKIP_UNLESS_BUILT("chipmunk");
  for (const double dt : {1.0 / 60, 1e-3}) {
    const std::vector<double> tops = bounces("chipmunk", dt, 14);
    ASSERT_EQ(tops.size(), 10U) << dt;
    for (const double top : tops) EXPECT_NEAR(top, 1, 0.01) << dt;
  }
}

// The step that meets the ground is fallen with the acceleration of the whole step: a bounce is up to g dt faster than the
// last. At 60 steps a second the ninth goes 1.41 times as high as the start, at 1000 the tenth 1.03 times.
TEST(Drop, climbs_in_box2d) {
  CAROM_SKIP_UNLESS_BUILT("box2d");
  const std::vector<double> coarse = bounces("box2d", 1.0 / 60, 14);
  ASSERT_EQ(coarse.size(), 9U);
  EXPECT_NEAR(coarse.front(), 0.957, 0.002);
  EXPECT_NEAR(coarse.back(), 1.409, 0.002);
  const std::vector<double> fine = bounces("box2d", 1e-3, 14);
  ASSERT_EQ(fine.size(), 10U);
  EXPECT_NEAR(fine.back(), 1.032, 0.002);
}

// Sixty steps a second make the ball climb, a thousand take its bounce: shorter steps are not better.
TEST(Drop, climbs_or_dies_in_bullet) {
  CAROM_SKIP_UNLESS_BUILT("bullet");
  const std::vector<double> coarse = bounces("bullet", 1.0 / 60, 14);
  ASSERT_GE(coarse.size(), 8U);
  EXPECT_GT(*std::max_element(coarse.begin(), coarse.end()), 1.3);
  const std::vector<double> fine = bounces("bullet", 1e-3, 14);
  ASSERT_GE(fine.size(), 1U);
  EXPECT_LT(fine.front(), 0.05);
}

}  // namespace
}  // namespace carom
