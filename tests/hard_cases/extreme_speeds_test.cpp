// Speeds that differ by powers of two in one scene, from 2^-400 to 2^400, and beyond what a scene may hold: up to 2^800
// apart everything meets as it should, beyond that is an InputError that says so. Squares of the slow ones are no doubles.

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

// A ball 2^k times faster than another hits it at rest as good as: equal masses exchange velocities, in each dimension.
TEST(ExtremeSpeeds, meet_as_any_others) {
  for (int d = 1; d <= 3; ++d)
    for (const int k : {0, 10, 60, 100, 200, 300, 380, 500, 640, 800}) {
      Scene scene = open_space(d);
      Coordinates x(std::size_t(d), 0.0), v(std::size_t(d), 0.0);
      v[0] = 1.0;
      scene.balls.push_back(ball(x, v));
      x[0] = 4.0;
      v[0] = -std::ldexp(1.0, -k);
      scene.balls.push_back(ball(x, v));
      const Result result = watched_run(scene, {.events = 5});
      ASSERT_EQ(result.log.size(), 1u) << d << "-D, 2^" << k;
      EXPECT_DOUBLE_EQ(result.log[0].time, 3.0 / (1.0 + std::ldexp(1.0, -k)));
      EXPECT_EQ(result.balls[1].velocity[0], 1.0);
      EXPECT_NEAR(result.balls[0].velocity[0], -std::ldexp(1.0, -k), d == 1 ? 0.0 : 0x1p-53);
    }
}

// Slow ones among themselves: the fast ball sets the clock, the slow pair meets by it as long as it lasts: 2^48 crossings.
TEST(ExtremeSpeeds, slow_pairs_beside_a_fast_ball) {
  for (const int k : {0, 10, 20, 30, 40}) {
    const double slow = std::ldexp(1.0, -k);
    Scene scene = open_space(2);
    scene.balls = {ball({0.0, 0.0}, {slow, 0.0}), ball({3.0, 0.5}, {-slow, 0.0}), ball({0.0, 50.0}, {1.0, 0.0})};
    const Result result = watched_run(scene, {.events = 5});
    ASSERT_EQ(result.log.size(), 1u) << "2^-" << k;
    EXPECT_NEAR(result.log[0].time * slow, (3.0 - std::sqrt(0.75)) / 2, 1e-14);
    EXPECT_LE(result.summary.momentum.relative_error.value(), 1e-15);
  }
}

// All directions at once: components 2^-380 beside 1, in position and velocity.
TEST(ExtremeSpeeds, tiny_components_do_no_harm) {
  for (const int k : {100, 200, 300, 380, 500, 790}) {
    const double tiny = std::ldexp(1.0, -k);
    Scene scene = box({-8.0, -8.0, -8.0}, {8.0, 8.0, 8.0});
    const double place = std::max(tiny, 0x1p-380);
    scene.balls = {ball({place, -2.0, place}, {tiny, 1.0, -tiny}), ball({-place, 2.0, 0.0}, {0.0, -1.0, tiny}),
                   ball({4.0, place, place}, {tiny, tiny, tiny}, 0.25)};
    const Result result = watched_run(scene, {.events = 200});
    EXPECT_EQ(result.stop, Stop::events);
    for (const BallState& b : result.balls) EXPECT_TRUE(std::isfinite(speed_of(b)));
  }
}

// Grazing by the smallest of gaps at such speeds: the sign is exact.
TEST(ExtremeSpeeds, graze_to_the_last_bit) {
  for (const int k : {-380, -200, 0, 200, 380})
    for (const int d : {2, 3})
      for (const double b : {1.0, std::nextafter(1.0, 2.0), std::nextafter(1.0, 0.0)}) {
        Scene scene = open_space(d);
        Coordinates x(std::size_t(d), 0.0), v(std::size_t(d), 0.0);
        x[0] = -5.0;
        x[1] = b;
        v[0] = std::ldexp(1.0, k);
        scene.balls = {ball(x, v), ball(Coordinates(std::size_t(d), 0.0), {})};
        EXPECT_EQ(watched_run(scene, {.events = 5}).log.size(), b < 1.0 ? 1u : 0u) << "2^" << k;
      }
}

// Both ends of the range in one scene, in each dimension: a ball of 2^400 comes down on the second of two that creep towards
// each other at 2^-400. They exchange; the struck one flies off, the other creeps on.
TEST(ExtremeSpeeds, both_ends_in_one_scene) {
  for (int d = 1; d <= 3; ++d) {
    const auto at = [d](double x) {
      Coordinates c(std::size_t(d), 0.0);
      c[0] = x;
      return c;
    };
    Scene scene = open_space(d);
    scene.balls = {ball(at(0.0), at(0x1p-400)), ball(at(3.0), at(-0x1p-400)), ball(at(6.0), at(-0x1p400))};
    const Result result = watched_run(scene, {.events = 5});
    ASSERT_EQ(result.log.size(), 2u) << d << "-D";
    EXPECT_DOUBLE_EQ(result.log[0].time, 0x1p-399);   // 2 / 2^400
    EXPECT_DOUBLE_EQ(result.log[1].time, 0x1p-398);   // and 2 more
    EXPECT_EQ(result.balls[0].velocity[0], -0x1p400);
    EXPECT_EQ(result.balls[1].velocity[0], 0x1p-400) << "that of ball 0, passed on";
    EXPECT_EQ(result.balls[2].velocity[0], -0x1p-400);
    EXPECT_EQ(result.stop, Stop::no_events_left);
  }
}

// Slow ones that touch do not need the clock: they exchange at once, by the sign of their approach, or slide apart.
TEST(ExtremeSpeeds, contacts_at_any_speed) {
  for (const int k : {400, 700, 800})
    for (const double sign : {1.0, -1.0})
      for (int d = 1; d <= 3; ++d) {
        const double slow = sign * std::ldexp(1.0, -k);
        Coordinates x(std::size_t(d), 0.0), v(std::size_t(d), 0.0);
        Scene scene = open_space(d);
        v[0] = slow;
        scene.balls.push_back(ball(x, v));
        x[0] = 1.0;
        v[0] = -slow;
        scene.balls.push_back(ball(x, v));
        x[0] = 9.0;
        v[0] = 1.0;
        scene.balls.push_back(ball(x, v));
        const Result result = watched_run(scene, {.events = 5});
        EXPECT_EQ(result.log.size(), sign > 0 ? 1u : 0u) << "2^-" << k << ", " << d << "-D";
        EXPECT_EQ(result.balls[0].velocity[0], -std::abs(slow));
        EXPECT_EQ(result.balls[1].velocity[0], std::abs(slow));
      }
}

// Beside a fast ball in a box, slow ones of any speed down to 2^-800 of it are as good as at rest until it hits them:
// collision by collision the log is the one of balls at rest.
TEST(ExtremeSpeeds, slow_is_as_good_as_at_rest) {
  const auto run = [](double slow) {
    Scene scene = box({0.0, 0.0}, {8.0, 8.0});
    scene.walls = {circle({4.0, 4.0}, 0.5, WallSide::outside)};
    scene.balls = {ball({1.0, 1.0}, {0x1p400, 0.75 * 0x1p400}), ball({6.0, 2.0}, {slow, -slow}), ball({2.0, 6.0}, {-slow, slow})};
    return watched_run(scene, {.events = 60});
  };
  const Result rest = run(0.0);
  for (const double slow : {0x1p-400, 0x1p-100, 0x1p100}) {
    const Result result = run(slow);
    ASSERT_EQ(result.log.size(), 60u);
    for (std::size_t i = 0; i < 60; ++i) {
      EXPECT_EQ(result.log[i].ball.number, rest.log[i].ball.number) << i;
      EXPECT_EQ(result.log[i].time, rest.log[i].time) << i;
    }
  }
}

// Balls of masses up to 10^20 apart that fall through a periodic space side by side, hardly moving against each other: they
// cross it up to 24 500 times each, and not once more for what the light ones might gain from the heavy ones.
TEST(ExtremeSpeeds, falling_together_ends) {
  for (const double g : {-9.81, 0.25}) {
    Scene scene = open_space(1);
    scene.space.kind = SpaceKind::periodic;
    scene.space.lower = {0.0};
    scene.space.upper = {8.0};
    scene.motion.acceleration = {g};
    scene.balls = {ball({5.3}, {2.2e-4}, 0.007, 7.4e-11), ball({7.1}, {2.3e-10}, 0.23, 4.2e9), ball({0.08}, {-6.4e-5}, 0.005, 0.18)};
    const Result result = watched_run(scene, {.until = 200.0});
    EXPECT_EQ(result.stop, Stop::until);
    EXPECT_TRUE(result.log.empty()) << "they drift by 0.05, and have 0.7";
    EXPECT_NEAR(result.balls[1].unwrapped_position[0], 7.1 + 2.3e-10 * 200 + g * 2e4, 1e-9);
  }
}

// Dissipation slows a ball down for ever: its squares underflow in the end, and nothing breaks.
TEST(ExtremeSpeeds, dying_away) {
  Scene scene = open_space(1);
  scene.space.kind = SpaceKind::box;
  scene.space.lower = {0.0};
  scene.space.upper = {2.0};
  scene.collision.restitution = 1e-6;
  scene.balls = {ball({1.0}, {1.0})};
  const Result result = watched_run(scene, {.events = 1000});
  EXPECT_TRUE(result.stop == Stop::no_events_left || result.stop == Stop::collapse);
  EXPECT_LT(result.log.size(), 10u) << "the next hit lies beyond the clock";
}

TEST(ExtremeSpeeds, beyond_the_range_are_refused) {
  for (const int k : {-801, -850, -1000}) {
    Scene scene = open_space(2);
    scene.balls = {ball({0.0, 0.0}, {1.0, 0.0}), ball({4.0, 0.0}, {std::ldexp(1.0, k), 0.0})};
    const auto texts = refusals(scene);
    ASSERT_EQ(texts.size(), 1u) << k;
    EXPECT_NE(texts[0].find("velocity"), std::string::npos);
    EXPECT_NE(texts[0].find("out of range"), std::string::npos);
  }
  Scene both = open_space(2);
  both.balls = {ball({0.0, 0.0}, {0x1p400, 0.0}), ball({4.0, 0.0}, {0x1p-400, 0.0})};
  EXPECT_EQ(refusals(both).size(), 0u) << "2^800 apart";
  both.balls[0].velocity[0] = 0x1p401;
  EXPECT_EQ(refusals(both).size(), 1u) << "2^801 apart";
  for (const double bad : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    Scene scene = open_space(2);
    scene.balls = {ball({0.0, 0.0}, {bad, 0.0})};
    EXPECT_FALSE(refusals(scene).empty());
  }
}

}  // namespace
}  // namespace carom
