// Turned, mirrored, renumbered. A mirror and a quarter turn in the plane change signs and names of axes: sums of two
// products do not depend on their order, so without ties the log is the same, bit for bit. Boxes of balls under mirrors and
// new numbers are in tests/sim/symmetry_test.cpp; here walls of all kinds and gravity are turned too. A general turn in
// space rounds the inputs: the order of events is the same up to where chaos has made that rounding as large as a gap.

#include <algorithm>

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

Scene plane_menagerie(std::uint64_t seed) {
  Scene scene = box({-8.0, -6.0}, {8.0, 6.0});
  scene.motion.acceleration = {0.1, -0.7};
  scene.walls = {segment({-6.0, -4.5}, {-3.0, -3.0}), polygon({{3.0, 1.0}, {5.5, 1.5}, {4.0, 3.5}}),
                 circle({0.1, 4.0}, 0.75, WallSide::outside), circle({0.0, 0.0}, 11.0, WallSide::inside)};
  Dice dice(seed);
  for (int i = 0; i < 6; ++i) {
    const double vx = dice.between(-1.0, 1.0), vy = dice.between(-1.0, 1.0), radius = i == 5 ? 0.0 : dice.between(0.1, 0.4);
    const double y = dice.between(-0.9, 0.5), mass = dice.between(0.5, 4.0);
    scene.balls.push_back(ball({-2.9 + i, y}, {vx, vy}, radius, mass));
  }
  scene.balls.push_back(fixed_ball({0.3, -3.0}, 0.625));
  return scene;
}

/// x' = sx * (x or y), y' = sy * (the other).
struct Turn {
  bool exchange;
  double sx, sy;

  template <class Pair>
  void operator()(Pair& p) const {
    if (p.empty()) return;
    if (exchange) std::swap(p[0], p[1]);
    p[0] = sx * p[0];
    p[1] = sy * p[1];
  }
};

Scene turned(Scene scene, const Turn& turn) {
  for (BallSpec& b : scene.balls) {
    turn(b.position);
    turn(b.velocity);
  }
  for (WallSpec& w : scene.walls) {
    for (Coordinates* c : {&w.from, &w.to, &w.point, &w.centre, &w.normal, &w.velocity}) turn(*c);
    for (Coordinates& c : w.vertices) turn(c);
  }
  turn(scene.motion.acceleration);
  turn(scene.space.lower);
  turn(scene.space.upper);
  for (std::size_t k = 0; k < scene.space.lower.size(); ++k)
    if (scene.space.lower[k] > scene.space.upper[k]) std::swap(scene.space.lower[k], scene.space.upper[k]);
  return scene;
}

/// Of the faces x-, x+, y-, y+ that a turn makes of one another.
std::uint32_t turned_wall(std::uint32_t wall, std::uint32_t faces_from, const Turn& turn) {
  if (wall < faces_from) return wall;
  std::uint32_t axis = (wall - faces_from) / 2, upper = (wall - faces_from) % 2;
  if (turn.exchange) axis = 1 - axis;
  if ((axis == 0 ? turn.sx : turn.sy) < 0) upper = 1 - upper;
  return faces_from + 2 * axis + upper;
}

TEST(Turned, by_quarters_and_mirrored_gives_the_turned_log) {
  for (std::uint64_t seed = 281; seed < 285; ++seed)
    for (const bool gravity : {true, false}) {
      Scene scene = plane_menagerie(seed);
      if (!gravity) scene.motion.acceleration.clear();
      const Result one = watched_run(scene, {.events = 400, .stride = 9, .energy_error = 1e-13});
      ASSERT_EQ(one.log.size(), 400u);
      ASSERT_EQ(one.summary.events.ties, 0) << "another seed";
      for (const Turn& turn : {Turn{false, -1, 1}, Turn{false, 1, -1}, Turn{false, -1, -1}, Turn{true, -1, 1},
                               Turn{true, 1, -1}, Turn{true, 1, 1}}) {
        const Result other = run(turned(scene, turn), 400);
        ASSERT_EQ(other.log.size(), 400u);
        for (std::size_t i = 0; i < 400; ++i) {
          Collision c = one.log[i];
          const Collision& q = other.log[i];
          for (Collision::Party* p : {&c.ball, &c.partner}) {
            turn(p->position);
            turn(p->velocity_after);
          }
          if (c.kind == EventKind::ball_wall) c.partner.number = turned_wall(c.partner.number, 4, turn);
          ASSERT_TRUE(c.epoch == q.epoch && c.offset == q.offset && c.kind == q.kind && c.feature == q.feature &&
                      c.ball.number == q.ball.number && c.partner.number == q.partner.number && c.impulse == q.impulse &&
                      c.ball.position == q.ball.position && c.ball.velocity_after == q.ball.velocity_after &&
                      c.partner.velocity_after == q.partner.velocity_after)
              << "seed " << seed << " gravity " << gravity << " turn " << turn.exchange << turn.sx << turn.sy
              << " collision " << i;
        }
      }
    }
}

// A cloud of spheres that falls in on itself, turned about a general axis: who hits whom is the same for the first dozens.
// Each generation of hits magnifies an error by mean free path / radius or so, here about tenfold: from 1e-15 to a gap's
// size in some fifteen generations of hits.
TEST(Turned, in_space_keeps_the_order_up_to_the_horizon) {
  Scene scene = mixed_box(3, 27, 8.0, 286, 0.6);
  scene.space = SpaceSpec{};
  for (BallSpec& b : scene.balls)
    for (std::size_t k = 0; k < 3; ++k) {
      b.position[k] = b.position[k] - 4.0;
      b.velocity[k] = 0.2 * b.velocity[k] - 0.3 * b.position[k];
    }
  const Result one = watched_run(scene, {.events = 30});
  // Rodrigues: cos 1 and sin 1 about (1, 2, 2) / 3.
  const double n[3] = {1.0 / 3, 2.0 / 3, 2.0 / 3}, c = std::cos(1.0), s = std::sin(1.0);
  const auto rotate = [&](Coordinates& x) {
    const double along = (n[0] * x[0] + n[1] * x[1] + n[2] * x[2]) * (1 - c);
    const double cross[3] = {n[1] * x[2] - n[2] * x[1], n[2] * x[0] - n[0] * x[2], n[0] * x[1] - n[1] * x[0]};
    Coordinates y;
    for (std::size_t k = 0; k < 3; ++k) y.push_back(c * x[k] + s * cross[k] + along * n[k]);
    x = y;
  };
  Scene other_scene = scene;
  for (BallSpec& b : other_scene.balls) {
    rotate(b.position);
    rotate(b.velocity);
  }
  // Renumbered as well: ball i becomes ball 26 - i.
  std::reverse(other_scene.balls.begin(), other_scene.balls.end());
  const Result other = watched_run(other_scene, {.events = 30});
  ASSERT_EQ(one.log.size(), 30u);
  ASSERT_EQ(other.log.size(), 30u);
  for (std::size_t i = 0; i < 30; ++i) {
    EXPECT_EQ(one.log[i].ball.number, 26 - other.log[i].partner.number) << i;
    EXPECT_EQ(one.log[i].partner.number, 26 - other.log[i].ball.number) << i;
    EXPECT_NEAR(one.log[i].time, other.log[i].time, 1e-8) << i;
  }
}

}  // namespace
}  // namespace carom
