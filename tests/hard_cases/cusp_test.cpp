// A point flies into the cusp between two touching disks. The channel is w = y^2 wide at the height y above the point of
// contact, so hits become unboundedly many in finite time as the aim goes deeper; but for every start beside the axis the
// count is finite, and the point comes out again, with all its energy. Elastic, so it is no collapse.
//
// Aimed straight down at x_0 beside the axis, the point first hits at y_1 = (2 x_0)^(1/2), and what follows scales: heights
// as x_0^(1/2), widths as x_0, velocities across as x_0^(1/2). Further down w v_across stays the same, of order x_0^(3/2),
// until v_across has become the whole speed: so the deepest point is at y ~ x_0^(3/4), and the number of hits, the integral
// of v_across / w dt, is ~ x_0^(-3/4).

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

Scene two_touching_disks() {
  Scene scene = open_space(2);
  scene.balls = {fixed_ball({-1.0, 0.0}, 1.0), fixed_ball({1.0, 0.0}, 1.0)};
  return scene;
}

TEST(Cusp, is_left_again_after_more_hits_the_deeper_the_aim) {
  double hits_before = 0.0, deepest_before = 0.0;
  for (const double aside : {1e-3, 1e-4, 1e-5, 1e-6}) {
    Scene scene = two_touching_disks();
    scene.balls.push_back(ball({aside, 1.0}, {0.0, -1.0}, 0.0));
    const Result result = watched_run(scene, {.events = 1'000'000, .stride = 97, .energy_error = 1e-13});
    EXPECT_EQ(result.stop, Stop::no_events_left) << aside;
    EXPECT_NEAR(speed_of(result.balls[2]), 1.0, 1e-12);
    EXPECT_GT(result.balls[2].velocity[1], 0.0) << "it comes back up";
    double deepest = 1.0;
    for (const Collision& c : result.log) deepest = std::min(deepest, c.partner.position[1]);
    EXPECT_GT(deepest, 0.0) << "not through the point of contact";
    const double hits = double(result.log.size()) * std::pow(aside, 0.75);
    deepest /= std::pow(aside, 0.75);
    if (aside < 1e-4) {
      EXPECT_NEAR(hits / hits_before, 1.0, 0.05) << aside;
      EXPECT_NEAR(deepest / deepest_before, 1.0, 0.05) << aside;
    }
    hits_before = hits;
    deepest_before = deepest;
  }
}

// From any height and direction.
TEST(Cusp, generic_starts_come_out) {
  Dice dice(261);
  for (int i = 0; i < 200; ++i) {
    Scene scene = two_touching_disks();
    const double x = dice.between(-0.2, 0.2), y = dice.between(0.8, 1.5);
    const double aim = dice.between(-0.02, 0.02), length = std::hypot(x - aim, y);
    scene.balls.push_back(ball({x, y}, {(aim - x) / length, -y / length}, 0.0));
    const Result result = watched_run(scene, {.events = 1'000'000, .stride = 101});
    EXPECT_EQ(result.stop, Stop::no_events_left) << i;
    EXPECT_NEAR(speed_of(result.balls[2]), 1.0, 1e-12);
  }
}

// Straight down the axis the point touches both disks at the point of contact and nowhere else, and overlaps neither:
// touching without turning negative is no event.
TEST(Cusp, straight_down_the_axis_there_is_no_event) {
  Scene scene = two_touching_disks();
  scene.balls.push_back(ball({0.0, 1.0}, {0.0, -1.0}, 0.0));
  const Result result = watched_run(scene, {.until = 2.0});
  EXPECT_TRUE(result.log.empty());
  EXPECT_EQ(result.balls[2].position[1], -1.0);
}

// A disk gets stuck on nothing: it touches both disks where it no longer fits, and comes straight back.
TEST(Cusp, a_disk_comes_straight_back) {
  Scene scene = two_touching_disks();
  scene.balls.push_back(ball({0.0, 3.0}, {0.0, -1.0}, 0.25));
  const Result result = watched_run(scene, {.events = 1000});
  EXPECT_EQ(result.stop, Stop::no_events_left);
  EXPECT_GT(result.balls[2].velocity[1], 0.0);
  EXPECT_NEAR(result.log[0].time, 3.0 - 0.75, 1e-15) << "1.25^2 = 1 + 0.75^2";
}

// The cusp between a disk and a plane.
TEST(Cusp, between_a_disk_and_a_wall) {
  std::size_t before = 0;
  for (const double aim : {1e-2, 1e-4, 1e-6}) {
    Scene scene = open_space(2);
    scene.walls = {plane({0.0, 0.0}, {0.0, 1.0}), circle({0.0, 1.0}, 1.0, WallSide::outside)};
    scene.balls = {ball({2.0, aim}, {-1.0, 0.0}, 0.0)};
    const Result result = watched_run(scene, {.events = 1'000'000, .stride = 101});
    EXPECT_EQ(result.stop, Stop::no_events_left) << aim;
    EXPECT_GT(result.log.size(), before);
    before = result.log.size();
    EXPECT_GT(result.balls[0].velocity[0], 0.0);
  }
}

}  // namespace
}  // namespace carom
