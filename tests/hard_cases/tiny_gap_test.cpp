// Row 2: gaps of 1e-12, of one ulp, of 0. A gap that is there is flown through: the hit comes at gap / speed, not at 0; a
// pair that separates has none. Gaps of exactly 0 are start_in_contact_test.cpp.

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

Scene pair_with_gap(double gap, double closing, int dimension) {
  Scene scene = open_space(dimension);
  Coordinates x0(std::size_t(dimension), 0.0), x1(std::size_t(dimension), 0.0), v(std::size_t(dimension), 0.0);
  x1[0] = 1.0 + gap;
  v[0] = closing;
  scene.balls = {ball(x0, v), ball(x1, {})};
  return scene;
}

TEST(TinyGap, is_flown_through_when_closing_and_no_event_when_separating) {
  for (int d = 1; d <= 3; ++d)
    for (const double gap : {0x1p-52, 0x1p-50, 1e-12, 1e-9}) {
      const double there = (1.0 + gap) - 1.0;  // the gap that the coordinates have
      const Result closing = watched_run(pair_with_gap(gap, 1.0, d), {});
      ASSERT_EQ(closing.log.size(), 1u) << d << "-D, gap " << gap;
      if (gap > 0x1p-51) {
        EXPECT_NEAR(closing.log[0].time / there, 1.0, 1e-3) << d << "-D, gap " << gap;
      }
      EXPECT_LE(closing.log[0].time, 1.001 * there);
      EXPECT_EQ(closing.balls[0].velocity[0], 0.0);
      EXPECT_EQ(closing.balls[1].velocity[0], 1.0);
      EXPECT_TRUE(watched_run(pair_with_gap(gap, -1.0, d), {}).log.empty());
      EXPECT_TRUE(watched_run(pair_with_gap(gap, 0.0, d), {}).log.empty());
    }
}

// A chain of ten tiny gaps: the blow arrives after the sum of the gaps, one hit after the other.
TEST(TinyGap, a_chain_of_them_takes_the_sum_of_the_flights) {
  for (const double gap : {1e-12, 1e-9}) {
    Scene scene = open_space(1);
    std::vector<double> x{-1.5};
    for (int i = 0; i < 10; ++i) x.push_back(i == 0 ? 0.0 : x.back() + 1.0 + gap);
    double flights = 0.5;
    for (std::size_t i = 0; i < x.size(); ++i) {
      scene.balls.push_back(ball({x[i]}, {i == 0 ? 1.0 : 0.0}));
      if (i > 1) flights += (x[i] - x[i - 1]) - 1.0;
    }
    const Result result = watched_run(scene, {});
    ASSERT_EQ(result.log.size(), 10u);
    EXPECT_EQ(result.summary.events.ties, 0) << "each hit has a moment of its own";
    EXPECT_NEAR(result.log.back().time - 0.5, flights - 0.5, 1e-15);
    for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(result.log[i].partner.number, i + 1);
  }
}

// A ball in a slot with 1e-12 to spare hits its sides at that interval.
TEST(TinyGap, between_a_ball_and_a_wall) {
  Scene scene = box({0.0, 0.0}, {1.0 + 1e-12, 10.0});
  scene.balls = {ball({0.5, 5.0}, {1.0, 0.1})};
  const Result result = watched_run(scene, {.events = 2000, .stride = 7});
  EXPECT_EQ(result.stop, Stop::events);
  EXPECT_NEAR(result.summary.time / 2000, 1e-12, 2e-16);
  EXPECT_EQ(std::abs(result.balls[0].velocity[0]), 1.0);
  EXPECT_EQ(result.balls[0].velocity[1], 0.1);
}

}  // namespace
}  // namespace carom
