// Walls in the engines: where they act, on which side, and by which number and feature they are reported.

#include <algorithm>
#include <cmath>
#include <set>

#include "engine_runs.hpp"

namespace carom {
namespace {

using test::EngineRun;
using test::run_engine;

class Wall : public test::EachEngine {
 protected:
  /// Bullet takes back part of an overlap by speed: up to 0.2 of the speed of an impact, and all of it at walls it feels
  /// early.
  [[nodiscard]] double speed_error() const { return engine() == "bullet" ? 0.21 : 1e-4; }
};
INSTANTIATE_TEST_SUITE_P(Engines, Wall, testing::ValuesIn(test::built_engines()), [](const auto& e) { return e.param; });
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Wall);

constexpr double dt = 0.01;

const StepContact& only(const EngineRun& run) {
  EXPECT_EQ(run.collisions.size(), 1U);
  static const StepContact none{};
  return run.collisions.empty() ? none : run.collisions.front();
}

// The faces follow the [[wall]]s: x-, x+, y-, y+ are 1 to 4 here.
TEST_P(Wall, faces_of_the_box_are_numbered_as_simulation_does) {
  const std::string scene = R"(
    run.until = 1
    space = { kind = "box", lower = [0, 0], upper = [6, 6] }
    [[wall]]
    kind = "segment"
    from = [0.5, 0.1]
    to = [0.6, 0.1]
    [[ball]]
    position = [3, 3]
    velocity = )";
  const char* away[] = {"[-4, 0]", "[4, 0]", "[0, -4]", "[0, 4]"};
  for (std::uint32_t face = 0; face < 4; ++face) {
    const EngineRun run = run_engine(engine(), scene + away[face], dt, 100);
    const StepContact& hit = only(run);
    EXPECT_EQ(hit.kind, EventKind::ball_wall);
    EXPECT_EQ(hit.ball, 0U);
    EXPECT_EQ(hit.partner, face + 1);
    EXPECT_EQ(hit.feature, 0);
    EXPECT_NEAR(hit.time, 2.5 / 4, 2 * dt);
    EXPECT_NEAR(hit.impulse, 8, 8 * speed_error());
  }
}

// Fifty discs of packing 0.1 with k_B T = 25, speeds of 5 and more, for two seconds at dt = 0.002: nobody leaves the box,
// and over a hundred impacts are seen. Overlaps of up to 0.2 are left by the engines.
TEST_P(Wall, box_keeps_a_gas_in) {
  const EngineRun run = run_engine(engine(), R"(
    run.until = 1
    space = { kind = "box", lower = [0, 0], upper = [20, 20] }
    [[gas]]
    count = 50
    radius = 0.5
    temperature = 25)",
                                   0.002, 1000);
  EXPECT_GT(run.collisions.size(), 100U);
  for (const BallState& b : run.balls)
    for (const double x : b.position) {
      EXPECT_GT(x, 0.3);
      EXPECT_LT(x, 19.7);
    }
}

// Normal (0.6, 0.8), e = 0.5: v' = v - 1.5 (v.n) n with v.n = -5.
TEST_P(Wall, plane_acts_along_its_normal_with_its_restitution) {
  const EngineRun run = run_engine(engine(), R"(
    run.until = 1
    [[ball]]
    position = [1.2, 1.6]
    velocity = [-3, -4]
    [[wall]]
    kind = "plane"
    point = [0, 0]
    normal = [3, 4]
    restitution = 0.5)",
                                   dt, 60);
  const StepContact& hit = only(run);
  EXPECT_EQ(hit.partner, 0U);
  EXPECT_NEAR(hit.time, 0.3, 2 * dt);
  const double rise = 0.6 * run.balls[0].velocity[0] + 0.8 * run.balls[0].velocity[1];
  EXPECT_NEAR(rise, 2.5, 5 * speed_error());
  EXPECT_NEAR(-0.8 * run.balls[0].velocity[0] + 0.6 * run.balls[0].velocity[1], 0, 1e-4);
}

// In the plane's frame the ball comes at 4 + 3 and leaves at 7: it goes at 10. Impulse 14.
TEST_P(Wall, plane_may_move) {
  const EngineRun run = run_engine(engine(), R"(
    run.until = 1
    [[ball]]
    position = [0, 0]
    velocity = [-4, 0]
    [[wall]]
    kind = "plane"
    point = [-4, 0]
    normal = [1, 0]
    velocity = [3, 0])",
                                   dt, 100);
  const StepContact& hit = only(run);
  EXPECT_NEAR(hit.time, 0.5, 2 * dt);
  EXPECT_NEAR(run.balls[0].velocity[0], 10, 14 * speed_error());
}

// Both sides of a segment act, and its ends are its features 1 and 2.
TEST_P(Wall, segment_has_two_sides_and_two_ends) {
  const std::string scene = R"(
    run.until = 1
    [[wall]]
    kind = "segment"
    from = [0, 0]
    to = [3, 0]
    [[ball]]
    )";
  const EngineRun above = run_engine(engine(), scene + "position = [2, 3]\nvelocity = [0, -5]", dt, 80);
  EXPECT_EQ(only(above).feature, 0);
  EXPECT_NEAR(above.balls[0].velocity[1], 5, 10 * speed_error());
  const EngineRun below = run_engine(engine(), scene + "position = [2, -3]\nvelocity = [0, 5]", dt, 80);
  EXPECT_EQ(only(below).feature, 0);
  EXPECT_NEAR(below.balls[0].velocity[1], -5, 10 * speed_error());
  const EngineRun from = run_engine(engine(), scene + "position = [-3, 0]\nvelocity = [5, 0]", dt, 80);
  EXPECT_EQ(only(from).feature, 1);
  EXPECT_NEAR(from.balls[0].velocity[0], -5, 10 * speed_error());
  const EngineRun to = run_engine(engine(), scene + "position = [6, 0]\nvelocity = [-5, 0]", dt, 80);
  EXPECT_EQ(only(to).feature, 2);
  EXPECT_NEAR(to.balls[0].velocity[0], 5, 10 * speed_error());
}

// A wall of four edges: 0 below, 1 right, 2 above, 3 left; its corners 4 to 7 cannot be met from inside.
TEST_P(Wall, polygon_tells_its_edges) {
  const EngineRun run = run_engine(engine(), R"(
    run.until = 1
    [[wall]]
    kind = "polygon"
    vertices = [[-4, -3], [4, -3], [4, 3], [-4, 3]]
    [[ball]]
    position = [0.2, 0.1]
    velocity = [6, 2.5])",
                                   dt, 500);
  std::set<std::int32_t> features;
  for (const StepContact& c : run.collisions) {
    EXPECT_EQ(c.partner, 0U);
    features.insert(c.feature);
  }
  EXPECT_EQ(features, (std::set<std::int32_t>{0, 1, 2, 3}));
  EXPECT_LT(std::abs(run.balls[0].position[0]), 3.7);
  EXPECT_LT(std::abs(run.balls[0].position[1]), 2.7);
}
TEST_P(Wall, polygon_has_corners_outside) {
  const EngineRun run = run_engine(engine(), R"(
    run.until = 1
    [[wall]]
    kind = "polygon"
    vertices = [[0, 0], [-2, 2], [-2, -2]]
    [[ball]]
    position = [3, 0]
    velocity = [-5, 0])",
                                   dt, 80);
  EXPECT_EQ(only(run).feature, 3);
  EXPECT_NEAR(run.balls[0].velocity[0], 5, 10 * speed_error());
}

TEST_P(Wall, circle_is_round_from_outside) {
  // At contact the centres are 1.5 apart, 0.9 across: n = (-0.8, 0.6), v' = v - 2 (v.n) n with v.n = -4.8. A contact that
  // is found a step late, 0.06 further, has turned the normal.
  const EngineRun run = run_engine(engine(), R"(
    run.until = 1
    [[ball]]
    position = [-5, 0.9]
    velocity = [6, 0]
    [[wall]]
    kind = "circle"
    centre = [0, 0]
    radius = 1
    side = "outside")",
                                   dt, 100);
  EXPECT_NEAR(only(run).time, 3.8 / 6, 2 * dt);
  EXPECT_NEAR(run.balls[0].velocity[0], 6 - 9.6 * 0.8, 0.6);
  EXPECT_NEAR(run.balls[0].velocity[1], 9.6 * 0.6, 0.6);
}

TEST_P(Wall, circle_holds_its_ball_inside) {
  // Chords of a circle of radius 4.5 at 1 (the angular momentum over the speed) from the centre: one each 2 sqrt(4.5^2 - 1)
  // / 5.
  const EngineRun run = run_engine(engine(), R"(
    run.until = 1
    [[ball]]
    position = [0, -1]
    velocity = [5, 0]
    [[wall]]
    kind = "circle"
    centre = [0, 0]
    radius = 5
    side = "inside")",
                                   0.002, 5000);
  EXPECT_LT(std::hypot(run.balls[0].position[0], run.balls[0].position[1]), 4.6);
  for (const StepContact& c : run.collisions) EXPECT_EQ(c.partner, 0U);
  if (engine() == "bullet") return;  // it loses its bounce
  EXPECT_NEAR(static_cast<double>(run.collisions.size()), 10 / (2 * std::sqrt(4.5 * 4.5 - 1) / 5), 1);
}

// On a line: balls of mass 1 and 3, e = 1, between two walls. v1' = -v, v2' = ... of the formulas: (4, 0) -> (-2, 2).
TEST_P(Wall, may_be_the_ends_of_a_line) {
  const EngineRun run = run_engine(engine(), R"(
    dimension = 1
    run.until = 1
    space = { kind = "box", lower = [0], upper = [10] }
    [[ball]]
    position = [2]
    velocity = [4]
    [[ball]]
    position = [3]
    mass = 3)",
                                   dt, 50);
  EXPECT_EQ(only(run).kind, EventKind::ball_ball);
  EXPECT_NEAR(run.balls[0].velocity[0], -2, 1e-5);
  EXPECT_NEAR(run.balls[1].velocity[0], 2, 1e-5);
  EXPECT_EQ(run.balls[0].position.size(), 1U);
  const EngineRun longer = run_engine(engine(), R"(
    dimension = 1
    run.until = 1
    space = { kind = "box", lower = [0], upper = [10] }
    [[ball]]
    position = [5]
    velocity = [9])",
                                      dt, 100);
  EXPECT_EQ(only(longer).partner, 1U);
  EXPECT_NEAR(longer.balls[0].velocity[0], -9, 18 * speed_error());
}

TEST(BulletWall, holds_in_space) {
  CAROM_SKIP_UNLESS_BUILT("bullet");
  const EngineRun box = run_engine("bullet", R"(
    dimension = 3
    run.until = 1
    space = { kind = "box", lower = [0, 0, 0], upper = [5, 5, 5] }
    [[ball]]
    position = [2, 2, 2]
    velocity = [5, 6, 7])",
                                   dt, 300);
  std::set<std::uint32_t> faces;
  for (const StepContact& c : box.collisions) faces.insert(c.partner);
  EXPECT_EQ(faces, (std::set<std::uint32_t>{0, 1, 2, 3, 4, 5}));
  for (const double x : box.balls[0].position) {
    EXPECT_GT(x, 0.3);
    EXPECT_LT(x, 4.7);
  }
  const EngineRun ball = run_engine("bullet", R"(
    dimension = 3
    run.until = 1
    [[ball]]
    position = [1, 0.3, 0.4]
    velocity = [3, 4, 5]
    [[wall]]
    kind = "circle"
    centre = [0, 0, 0]
    radius = 5
    side = "inside")",
                                    dt, 500);
  EXPECT_GT(ball.collisions.size(), 3U);
  const auto& x = ball.balls[0].position;
  EXPECT_LT(std::hypot(x[0], x[1], x[2]), 4.6);
}

// What Bullet finds at a gap g within 0.02 m of a wall, it slows so that it would just arrive: the bounce loses g / dt.
// Steps of 1/16 at speed 4 leave a gap of 0.01: v' = 4 - 0.01 * 64.
TEST(BulletWall, takes_speed_from_a_bounce_that_it_feels_early) {
  CAROM_SKIP_UNLESS_BUILT("bullet");
  const std::string scene = R"(
    run.until = 1
    [[ball]]
    position = [0, 0]
    velocity = [4, 0]
    [[wall]]
    kind = "plane"
    normal = [-1, 0]
    point = [)";
  EXPECT_NEAR(run_engine("bullet", scene + "0.76, 0]", 1.0 / 64, 20).balls[0].velocity[0], -(4 - 0.01 * 64), 1e-4);
  // So a short step takes all of it.
  EXPECT_NEAR(run_engine("bullet", scene + "2.5, 0]", 1e-4, 10000).balls[0].velocity[0], 0, 0.01);
}

}  // namespace
}  // namespace carom
