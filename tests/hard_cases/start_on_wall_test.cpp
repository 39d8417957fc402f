// Row 7: starting exactly on a wall. Which side of a two-sided wall a point is on is what its velocity says; a disk that
// touches stays on its own side. Faces of a box are in tests/sim/contact_test.cpp (StartOnWall).

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

// A disk on the inside of a circle, on the outside of a pillar, on a plane and on a segment, in any direction: pressed in
// it acts at once, pulled away it does not, and it never gets to the other side.
TEST(StartOnAnyWall, acts_at_once_if_pressed) {
  Dice dice(71);
  for (int i = 0; i < 400; ++i) {
    const double turn = dice.between(0.0, 6.28), c = std::cos(turn), s = std::sin(turn);
    const long double size = std::sqrt(static_cast<long double>(c) * c + static_cast<long double>(s) * s);
    const double radius = i % 5 == 0 ? 0.0 : dice.between(0.1, 0.9);
    const double inward = i % 2 == 0 ? 1.0 : -1.0;
    const int kind = i % 4;
    Scene scene = open_space(2);
    long double distance = radius;  // of the centre from the origin, along (c, s)
    if (kind == 0) {
      scene.walls = {circle({0.0, 0.0}, 2.0, WallSide::inside)};
      distance = 2.0L - radius;
    }
    if (kind == 1) {
      scene.walls = {circle({0.0, 0.0}, 2.0, WallSide::outside)};
      distance = 2.0L + radius;
    }
    if (kind == 2) scene.walls = {plane({0.0, 0.0}, {c, s})};
    if (kind == 3) scene.walls = {segment({2 * s, -2 * c}, {-2 * s, 2 * c})};
    const double along = dice.between(-0.3, 0.3), away = kind == 0 ? -inward : inward;
    scene.balls = {ball({double(distance * c / size), double(distance * s / size)},
                        {away * c - along * s, away * s + along * c}, radius)};
    Simulation simulation(scene);
    simulation.advance(Number(0.0));
    const bool free_to_choose = kind == 3 && radius == 0.0;
    EXPECT_EQ(simulation.counts().ball_wall, inward < 0 && !free_to_choose ? 1 : 0) << "kind " << kind << ", case " << i;
    const Result result = watched_run(scene, {.until = 30.0});
    const double x = result.balls[0].position[0], y = result.balls[0].position[1];
    const double from_centre = std::hypot(x, y);
    if (kind == 0) {
      EXPECT_LE(from_centre, 2.0 - radius + 1e-12) << i;
    }
    if (kind == 1) {
      EXPECT_GE(from_centre, 2.0 + radius - 1e-12) << i;
    }
    if (kind == 2 || (kind == 3 && radius > 0)) {
      EXPECT_GE(c * x + s * y, radius - 1e-12) << i;
    }
  }
}

// The same with gravity along the wall's normal: a ball that starts on the floor with an upward velocity v comes back after
// 2 v / g, and with e = 1 for ever.
TEST(StartOnAnyWall, under_gravity) {
  for (const double radius : {0.0, 0.5}) {
    Scene scene = open_space(2);
    scene.motion.acceleration = {0.0, -10.0};
    scene.walls = {segment({-50.0, 0.0}, {50.0, 0.0})};
    scene.balls = {ball({0.0, radius}, {0.1, 5.0}, radius)};
    const Result result = watched_run(scene, {.events = 50});
    ASSERT_EQ(result.log.size(), 50u);
    for (std::size_t i = 0; i < 50; ++i) EXPECT_NEAR(result.log[i].time, double(i + 1), 1e-12);
  }
}

// At the end of a segment and at a polygon's vertex: the start is a contact of no direction. The point flies where its
// velocity points to, and is found there.
TEST(StartOnAnyWall, at_an_end_or_a_vertex) {
  for (int k = 0; k < 16; ++k) {
    const double turn = 0.1 + 0.39 * k;
    for (const bool closed : {false, true}) {
      Scene scene = open_space(2);
      if (closed) scene.walls = {polygon({{0.0, 0.0}, {2.0, 0.0}, {0.0, 2.0}})};
      if (!closed) scene.walls = {segment({0.0, 0.0}, {2.0, 0.0})};
      scene.balls = {ball({0.0, 0.0}, {std::cos(turn), std::sin(turn)}, 0.0)};
      const Result result = watched_run(scene, {.events = 1000, .until = 0.5});
      EXPECT_EQ(result.log.size(), 0u) << turn;
      EXPECT_NEAR(result.balls[0].position[0], 0.5 * std::cos(turn), 1e-15);
      EXPECT_NEAR(result.balls[0].position[1], 0.5 * std::sin(turn), 1e-15);
    }
  }
}

}  // namespace
}  // namespace carom
