// Speeds that differ by powers of two in one scene, up to 2^380 and beyond what a scene may hold: within 2^400 of its unit
// everything meets as it should, beyond it is an InputError that says so. Squares of such speeds lie near the ends of what
// doubles hold.

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

// A ball 2^k times faster than another hits it at rest as good as: equal masses exchange velocities, in each dimension.
TEST(ExtremeSpeeds, meet_as_any_others) {
  for (int d = 1; d <= 3; ++d)
    for (const int k : {0, 10, 60, 100, 200, 300, 380}) {
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
  for (const int k : {100, 200, 300, 380}) {
    const double tiny = std::ldexp(1.0, -k);
    Scene scene = box({-8.0, -8.0, -8.0}, {8.0, 8.0, 8.0});
    scene.balls = {ball({tiny, -2.0, tiny}, {tiny, 1.0, -tiny}), ball({-tiny, 2.0, 0.0}, {0.0, -1.0, tiny}),
                   ball({4.0, tiny, tiny}, {tiny, tiny, tiny}, 0.25)};
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
  for (const int k : {-400, -450, -800}) {
    Scene scene = open_space(2);
    scene.balls = {ball({0.0, 0.0}, {1.0, 0.0}), ball({4.0, 0.0}, {std::ldexp(1.0, k), 0.0})};
    const auto texts = refusals(scene);
    ASSERT_EQ(texts.size(), 1u) << k;
    EXPECT_NE(texts[0].find("velocity"), std::string::npos);
    EXPECT_NE(texts[0].find("out of range"), std::string::npos);
  }
  Scene both = open_space(2);
  both.balls = {ball({0.0, 0.0}, {0x1p400, 0.0}), ball({4.0, 0.0}, {0x1p-400, 0.0})};
  EXPECT_EQ(refusals(both).size(), 1u) << "2^800 apart";
  for (const double bad : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    Scene scene = open_space(2);
    scene.balls = {ball({0.0, 0.0}, {bad, 0.0})};
    EXPECT_FALSE(refusals(scene).empty());
  }
}

}  // namespace
}  // namespace carom
