// Row 19: a fixed step has several collisions in it, in an order that is lost. Here collisions come by time however close
// they are, down to one tick of the clock; and the time order of the log is never broken, in any scene.

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

// Two pairs whose meetings are one ulp of a coordinate apart; whichever pair has the smaller numbers.
TEST(OrderInAStep, is_by_time_to_the_last_bit) {
  for (const bool first_is_first : {true, false}) {
    Scene scene = open_space(2);
    const double near = 3.0, far = std::nextafter(3.0, 4.0);
    scene.balls = {ball({0.0, 0.0}, {1.0, 0.0}), ball({first_is_first ? near : far, 0.0}, {}), ball({0.0, 5.0}, {1.0, 0.0}),
                   ball({first_is_first ? far : near, 5.0}, {})};
    const Result result = watched_run(scene, {});
    ASSERT_EQ(result.log.size(), 2u);
    EXPECT_EQ(result.log[0].ball.number, first_is_first ? 0u : 2u);
    EXPECT_EQ(result.log[0].time, 2.0);
    EXPECT_GT(result.log[1].time, 2.0);
  }
}

// The cue ball reaches the nearer of two first, whatever comes next depends on it: three balls in a step of 0.5.
TEST(OrderInAStep, decides_who_is_hit) {
  Scene scene = open_space(2);
  scene.balls = {ball({0.0, 0.0}, {10.0, 0.0}), ball({2.0, 0.5}, {}), ball({2.25, -0.5}, {})};
  const Result result = watched_run(scene, {});
  ASSERT_GE(result.log.size(), 2u);
  EXPECT_EQ(result.log[0].partner.number, 1u);
  std::swap(scene.balls[1], scene.balls[2]);
  const Result renamed = watched_run(scene, {});
  EXPECT_EQ(renamed.log[0].partner.number, 2u) << "numbers are names";
  EXPECT_EQ(result.log.size(), renamed.log.size());
}

TEST(OrderInAStep, is_never_broken) {
  Scene crowd = mixed_box(2, 36, 12.0, 191, 0.7);
  Scene gravity = crowd;
  gravity.motion.acceleration = {0.0, -1.0};
  for (const Scene& scene : {crowd, gravity}) {
    const Result result = watched_run(scene, {.events = scaled_count(5000), .stride = 43, .energy_error = 1e-13});
    for (std::size_t i = 1; i < result.log.size(); ++i) {
      const Collision &a = result.log[i - 1], &b = result.log[i];
      ASSERT_TRUE(a.epoch < b.epoch || (a.epoch == b.epoch && a.offset <= b.offset)) << i;
    }
  }
}

}  // namespace
}  // namespace carom
