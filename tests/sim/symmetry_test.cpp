// What the laws of mechanics do not see, the simulator does not see: numbers, mirrors, frames, units, the direction of
// time.

#include <gtest/gtest.h>

#include <numeric>

#include "sim/properties.hpp"
#include "sim/scenes.hpp"

namespace carom {
namespace {

using namespace testing;

struct Choice {
  std::uint64_t seed;
  int dimension;
  int balls;
  double restitution;
};

Choice any_choice() {
  Choice c;
  c.seed = *rc::gen::inRange<std::uint64_t>(0, 1'000'000);
  c.dimension = *rc::gen::inRange(1, 4);
  c.balls = *rc::gen::inRange(2, 10);
  c.restitution = *rc::gen::element(1.0, 1.0, 0.9, 0.6);
  return c;
}

/// A box that is its own mirror image, or open space with balls that fall in on each other.
Scene scene_of(const Choice& c) {
  Scene scene = c.dimension == 1 ? rods(c.balls, c.seed) : mixed_box(c.dimension, c.balls, 8.0, c.seed);
  scene.collision.restitution = c.restitution;
  const double shift = c.dimension == 1 ? scene.space.upper[0] / 2 : 4.0;
  for (BallSpec& b : scene.balls)
    for (Number& x : b.position) x = x - shift;
  for (Number& x : scene.space.lower) x = -shift;
  for (Number& x : scene.space.upper) x = shift;
  return scene;
}

Scene opened(Scene scene) {
  scene.space = SpaceSpec{};
  for (BallSpec& b : scene.balls)
    for (std::size_t k = 0; k < b.position.size(); ++k) b.velocity[k] = 0.2 * b.velocity[k] - 0.3 * b.position[k];
  return scene;
}

const std::int64_t few = 30;

TEST(Symmetry, momentum_angular_momentum_and_energy_are_conserved) {
  expect_property(
      [] {
        const Scene scene = opened(scene_of(any_choice()));
        const Result result = run(scene, 1000);
        RC_ASSERT(result.summary.energy.relative_error <= 4e-16);
        RC_ASSERT(result.summary.momentum.relative_error.value() <= 1e-15);
        RC_ASSERT(result.summary.angular_momentum.relative_error.value_or(0.0) <= 1e-13);
        RC_ASSERT(result.summary.exactness.clamped == 0);
        RC_ASSERT(result.summary.exactness.max_gap_error <= 1e-12);
      },
      static_cast<int>(scaled_count(300)), 1);
}

// The numbers of the balls are names. With the balls in another order the same happens, bit for bit.
TEST(Symmetry, numbers_are_names) {
  expect_property(
      [] {
        const Choice choice = any_choice();
        const Scene scene = scene_of(choice);
        std::vector<std::uint32_t> place(scene.balls.size());  // ball i of the scene is number place[i] in the other
        std::iota(place.begin(), place.end(), 0u);
        Dice dice(choice.seed + 1);
        for (std::size_t i = place.size(); i-- > 1;) std::swap(place[i], place[std::size_t(dice.unit() * double(i + 1))]);
        Scene other = scene;
        for (std::size_t i = 0; i < place.size(); ++i) other.balls[place[i]] = scene.balls[i];
        const Result a = run(scene, few), b = run(other, few);
        RC_PRE(a.summary.events.ties == 0);
        RC_ASSERT(a.log.size() == b.log.size());
        for (std::size_t i = 0; i < a.log.size(); ++i) {
          Collision renamed = a.log[i];
          renamed.ball.number = place[renamed.ball.number];
          if (renamed.kind == EventKind::ball_ball) {
            renamed.partner.number = place[renamed.partner.number];
            if (renamed.partner.number < renamed.ball.number) std::swap(renamed.ball, renamed.partner);
          }
          RC_ASSERT(same_collision(renamed, b.log[i]));
        }
      },
      static_cast<int>(scaled_count(300)), 2);
}

Scene mirrored(Scene scene, std::size_t axis) {
  for (BallSpec& b : scene.balls) {
    b.position[axis] = -b.position[axis];
    b.velocity[axis] = -b.velocity[axis];
  }
  return scene;
}

TEST(Symmetry, a_mirror_changes_signs_only) {
  expect_property(
      [] {
        const Choice choice = any_choice();
        const Scene scene = scene_of(choice);
        const std::size_t axis = *rc::gen::inRange<std::size_t>(0, std::size_t(choice.dimension));
        const Result a = run(scene, few), b = run(mirrored(scene, axis), few);
        RC_PRE(a.summary.events.ties == 0);
        RC_ASSERT(a.log.size() == b.log.size());
        for (std::size_t i = 0; i < a.log.size(); ++i) {
          const Collision &p = a.log[i], &q = b.log[i];
          RC_ASSERT(p.epoch == q.epoch && p.offset == q.offset && p.kind == q.kind && p.impulse == q.impulse);
          RC_ASSERT(p.ball.number == q.ball.number);
          const auto same = [&](const Collision::Party& x, const Collision::Party& y) {
            bool s = true;
            for (std::size_t k = 0; k < 3; ++k) {
              const double sign = k == axis ? -1.0 : 1.0;
              s = s && x.position[k] == sign * y.position[k] && x.velocity_after[k] == sign * y.velocity_after[k];
            }
            return s;
          };
          RC_ASSERT(same(p.ball, q.ball));
          if (p.kind == EventKind::ball_ball) {
            RC_ASSERT(p.partner.number == q.partner.number);
            RC_ASSERT(same(p.partner, q.partner));
          }
        }
      },
      static_cast<int>(scaled_count(300)), 3);
}

// Exchanging the axes: sums over components run in another order, so the first hits agree within rounding.
TEST(Symmetry, exchanged_axes) {
  expect_property(
      [] {
        Choice choice = any_choice();
        choice.dimension = *rc::gen::inRange(2, 4);
        const Scene scene = scene_of(choice);
        Scene turned = scene;
        for (BallSpec& b : turned.balls) {
          std::swap(b.position[0], b.position[1]);
          std::swap(b.velocity[0], b.velocity[1]);
        }
        const Result a = run(scene, 4), b = run(turned, 4);
        RC_PRE(a.summary.events.ties == 0);
        for (std::size_t i = 0; i < a.log.size(); ++i) {
          RC_ASSERT(a.log[i].ball.number == b.log[i].ball.number);
          RC_ASSERT(std::abs(a.log[i].time - b.log[i].time) <= 1e-9 * (1 + a.log[i].time));
          RC_ASSERT(std::abs(a.log[i].ball.position[0] - b.log[i].ball.position[1]) <= 1e-9);
        }
      },
      static_cast<int>(scaled_count(200)), 4);
}

// Powers of two as units of length, time and mass: nothing is rounded, so the logs agree bit for bit.
TEST(Symmetry, units_are_conventions) {
  expect_property(
      [] {
        const Scene scene = scene_of(any_choice());
        const int length = *rc::gen::inRange(-100, 101), time = *rc::gen::inRange(-100, 101),
                  mass = *rc::gen::inRange(-100, 101);
        Scene other = scene;
        for (BallSpec& b : other.balls) {
          for (Number& x : b.position) x = std::ldexp(x, length);
          for (Number& v : b.velocity) v = std::ldexp(v, length - time);
          b.radius = std::ldexp(b.radius, length);
          b.mass = std::ldexp(b.mass, mass);
        }
        for (Coordinates* c : {&other.space.lower, &other.space.upper})
          for (Number& x : *c) x = std::ldexp(x, length);
        const Result a = run(scene, few), b = run(other, few);
        RC_ASSERT(a.log.size() == b.log.size());
        for (std::size_t i = 0; i < a.log.size(); ++i) {
          Collision c = a.log[i];
          c.offset = std::ldexp(c.offset, time);
          for (Collision::Party* p : {&c.ball, &c.partner})
            for (std::size_t k = 0; k < 3; ++k) {
              p->position[k] = std::ldexp(p->position[k], length);
              p->velocity_before[k] = std::ldexp(p->velocity_before[k], length - time);
              p->velocity_after[k] = std::ldexp(p->velocity_after[k], length - time);
            }
          c.gap = std::ldexp(c.gap, length);
          c.impulse = std::ldexp(c.impulse, mass + length - time);
          c.dissipated = std::ldexp(c.dissipated, mass + 2 * (length - time));
          RC_ASSERT(same_collision(c, b.log[i]));
        }
        RC_ASSERT(a.summary.energy.relative_error == b.summary.energy.relative_error);
      },
      static_cast<int>(scaled_count(300)), 5);
}

// The same collisions in a moving frame, for a few events: the boost rounds the velocities.
TEST(Symmetry, frames_that_move) {
  expect_property(
      [] {
        const Scene scene = opened(scene_of(any_choice()));
        const double speed = *rc::gen::element(0.5, -3.0, 10.0);
        Scene moving = scene;
        for (BallSpec& b : moving.balls)
          for (Number& v : b.velocity) v = v + speed;
        const Result a = run(scene, 4), b = run(moving, 4);
        RC_PRE(a.summary.events.ties == 0);
        RC_ASSERT(a.log.size() == b.log.size());
        for (std::size_t i = 0; i < a.log.size(); ++i) {
          const Collision &p = a.log[i], &q = b.log[i];
          RC_ASSERT(p.ball.number == q.ball.number && p.partner.number == q.partner.number);
          RC_ASSERT(std::abs(p.time - q.time) <= 1e-8);
          for (std::size_t k = 0; k < scene.balls[0].position.size(); ++k)
            RC_ASSERT(std::abs(p.ball.velocity_after[k] + speed - q.ball.velocity_after[k]) <= 1e-7);
        }
      },
      static_cast<int>(scaled_count(200)), 6);
}

// Elastic mechanics runs backwards: stop, turn all velocities round, and arrive where it began. Chaos loses a digit or so a
// collision of a pair, so few events and a wide bound: an error of principle would be of order 1.
TEST(Symmetry, time_runs_backwards) {
  expect_property(
      [] {
        Choice choice = any_choice();
        choice.restitution = 1.0;
        Scene scene = scene_of(choice);
        Simulation there(scene);
        there.advance(std::nullopt, 6);
        const double until = there.time() * (1 + 0x1p-20);
        if (there.advance(Number(until)) == Stop::events) RC_DISCARD();
        const std::int64_t events = there.counts().collisions();
        Scene back = scene;
        for (const BallState& b : there.balls()) {
          back.balls[b.index].position = Coordinates(b.position.begin(), b.position.end());
          back.balls[b.index].velocity.clear();
          for (const double v : b.velocity) back.balls[b.index].velocity.push_back(-v);
        }
        const Result result = run_until(back, until);
        RC_ASSERT(result.summary.events.collisions() == events);
        for (const BallState& b : result.balls)
          for (std::size_t k = 0; k < b.position.size(); ++k)
            RC_ASSERT(std::abs(b.position[k] - scene.balls[b.index].position[k].value) <= 1e-6);
      },
      static_cast<int>(scaled_count(200)), 7);
}

}  // namespace
}  // namespace carom
