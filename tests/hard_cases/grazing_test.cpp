// Row 1: grazing. |r + v t|^2 - sigma^2 has a double root where the path is tangent to the contact circle. Touching 0
// without turning negative is no event; the exact sign of the discriminant decides. One ulp beside a tangent along an axis
// is in tests/sim/contact_test.cpp; here: oblique tangents, walls of every shape, parabolas, and what a deep graze does.

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

// v = (3, 4) at 5 times the tangent's distance: with r = (-3 k - 4 s, -4 k + 3 s), r x v / |v| = -5 s, exactly in doubles.
// sigma = 5 s is a tangent; a larger or smaller radius by one ulp decides.
TEST(ObliqueGraze, one_ulp_of_the_radius_decides) {
  const auto hits = [](double radius) {
    Scene scene = open_space(2);
    scene.balls = {ball({-3.0 * 8 - 4 * 0.25, -4.0 * 8 + 3 * 0.25}, {3.0, 4.0}, radius), fixed_ball({0.0, 0.0}, 1.0)};
    return watched_run(scene, {.until = 20.0}).log.size();
  };
  EXPECT_EQ(hits(0.25), 0u) << "5 * 0.25 = 1 + 0.25: a tangent";
  EXPECT_EQ(hits(std::nextafter(0.25, 0.0)), 0u);
  EXPECT_EQ(hits(0.25 + 0x1p-52), 1u);
}

// The same on a pillar (a circle with the balls outside), on a segment's end, and in 3-D on a sphere.
TEST(ObliqueGraze, on_pillars_and_ends) {
  const auto hits = [](const WallSpec& wall, double radius) {
    Scene scene = open_space(2);
    scene.walls = {wall};
    scene.balls = {ball({-25.0, -31.25}, {3.0, 4.0}, radius)};
    return watched_run(scene, {.until = 20.0}).log.size();
  };
  const WallSpec pillar = circle({0.0, 0.0}, 1.0, WallSide::outside);
  EXPECT_EQ(hits(pillar, 0.25), 0u);
  EXPECT_EQ(hits(pillar, 0.25 + 0x1p-52), 1u);
  const WallSpec below = segment({0.0, 0.0}, {4.0, -3.0});  // square to the path, its end at the distance 5/4
  EXPECT_EQ(hits(below, 1.25), 0u);
  EXPECT_EQ(hits(below, 1.25 + 0x1p-52), 1u);
}

// A barely grazing elastic hit: sin(angle) = sqrt(1 - b^2), so the velocity turns by twice that and keeps its size.
TEST(ObliqueGraze, turns_by_what_its_depth_says) {
  for (const double depth : {1e-15, 1e-12, 1e-8, 1e-4}) {
    const double b = 1.0 - depth;
    Scene scene = open_space(2);
    scene.balls = {ball({-5.0, b}, {1.0, 0.0}), fixed_ball({0.0, 0.0})};
    const Result result = watched_run(scene, {.until = 20.0});
    ASSERT_EQ(result.log.size(), 1u) << depth;
    const double c = std::sqrt((1.0 - b) * (1.0 + b));  // cosine of the angle of incidence
    EXPECT_NEAR(result.balls[0].velocity[1] / (2 * c * b), 1.0, 1e-7) << depth;
    EXPECT_NEAR(speed_of(result.balls[0]), 1.0, 2e-16);
  }
}

// A parabola whose top touches a ceiling: y = v t - t^2 / 2 reaches v^2 / 2 = 2 at t = 2, and turns.
TEST(ParabolaGraze, the_top_touches_and_is_no_event) {
  const auto hits = [](double ceiling, int dimension) {
    Scene scene = open_space(dimension);
    Coordinates down(std::size_t(dimension), 0.0), start(std::size_t(dimension), 0.0), up(std::size_t(dimension), 0.0);
    down.back() = -1.0;
    scene.motion.acceleration = down;
    Coordinates point(std::size_t(dimension), 0.0);
    point.back() = ceiling;
    scene.walls = {plane(point, down)};
    up.back() = 2.0;
    scene.balls = {ball(start, up, 0.0)};
    return watched_run(scene, {.until = 3.5}).log.size();
  };
  for (int d = 1; d <= 3; ++d) {
    EXPECT_EQ(hits(2.0, d), 0u) << d << "-D";
    EXPECT_EQ(hits(std::nextafter(2.0, 3.0), d), 0u);
    EXPECT_EQ(hits(std::nextafter(2.0, 1.0), d), 1u);
  }
}

// And whose top touches a fixed ball from below: the quartic has a double root there.
TEST(ParabolaGraze, the_top_touches_a_ball) {
  const auto hits = [](double height) {
    Scene scene = open_space(2);
    scene.motion.acceleration = {0.0, -1.0};
    scene.balls = {ball({0.0, 0.0}, {0.0, 2.0}, 0.25), fixed_ball({0.0, height}, 0.75)};
    return watched_run(scene, {.until = 3.5}).log.size();
  };
  EXPECT_EQ(hits(3.0), 0u) << "the top is 2, and the radii add up to 1";
  EXPECT_EQ(hits(std::nextafter(3.0, 4.0)), 0u);
  EXPECT_EQ(hits(std::nextafter(3.0, 2.0)), 1u);
}

}  // namespace
}  // namespace carom
