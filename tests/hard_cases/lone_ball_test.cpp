// Row 21: a ball that never collides. The run ends at `until`, or says that no events are left; the ball is where it flew.

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

TEST(LoneBall, ends_at_until_or_at_once) {
  for (int d = 1; d <= 3; ++d)
    for (const bool periodic : {false, true})
      for (const double pull : {0.0, 2.0}) {
        Scene scene = open_space(d);
        if (periodic) {
          scene.space.kind = SpaceKind::periodic;
          scene.space.lower = Coordinates(std::size_t(d), 0.0);
          scene.space.upper = Coordinates(std::size_t(d), 8.0);
        }
        if (pull != 0.0) {
          scene.motion.acceleration = Coordinates(std::size_t(d), 0.0);
          scene.motion.acceleration[0] = pull;
        }
        Coordinates v(std::size_t(d), 0.0);
        v[0] = 1.0;
        scene.balls = {ball(Coordinates(std::size_t(d), 1.0), v, 0.25)};
        const Result result = watched_run(scene, {.until = 1024.0});
        EXPECT_TRUE(result.stop == Stop::no_events_left || (periodic && result.stop == Stop::until));
        EXPECT_TRUE(result.log.empty());
        EXPECT_EQ(result.summary.time, 1024.0);
        EXPECT_EQ(result.balls[0].unwrapped_position[0], 1.0 + 1024.0 + pull / 2 * 1024.0 * 1024.0);
        const Result endless = watched_run(scene, {});
        EXPECT_EQ(endless.stop, Stop::no_events_left) << "nothing will ever happen";
        EXPECT_EQ(endless.summary.time, 0.0) << "without `until`, the last event or the start";
      }
}

// Balls in a periodic space that pass each other for ever, beside fixed ones and on lanes of their own; cells are crossed
// without end, and the run still ends.
TEST(LoneBall, among_others_that_it_never_meets) {
  for (const SearchKind search : {SearchKind::automatic, SearchKind::cells}) {
    Scene scene = open_space(2);
    scene.engine.search = search;
    scene.space.kind = SpaceKind::periodic;
    scene.space.lower = {0.0, 0.0};
    scene.space.upper = {16.0, 16.0};
    for (int lane = 0; lane < 6; ++lane) scene.balls.push_back(ball({2.0, 1.5 + 2 * lane}, {0.5 * lane, 0.0}));
    scene.balls.push_back(fixed_ball({8.0, 14.5}));
    EXPECT_EQ(watched_run(scene, {}).stop, Stop::no_events_left);
    scene.balls.push_back(ball({10.0, 3.5}, {0.25, 0.0}));  // on the lane of ball 1, whose speed is 1/2
    const Result result = watched_run(scene, {.events = 20, .until = 1e5});
    EXPECT_EQ(result.log.size(), 20u);
    EXPECT_EQ(result.log[0].time, 28.0);
  }
}

// Apart in open space, by cells: nobody crosses them for ever.
TEST(LoneBall, in_a_crowd_that_flies_apart) {
  for (const double pull : {0.0, 1.0}) {
    Scene scene = open_space(2);
    scene.engine.search = SearchKind::cells;
    if (pull != 0.0) scene.motion.acceleration = {0.0, pull};
    for (int i = 0; i < 64; ++i) {
      const double x = 2.0 * (i % 8) - 7.0, y = 2.0 * (i / 8) - 7.0;
      scene.balls.push_back(ball({x, y}, {x, y}));
    }
    const Result result = watched_run(scene, {});
    EXPECT_EQ(result.stop, Stop::no_events_left);
    EXPECT_TRUE(result.log.empty());
  }
}

// At rest, in a box, with walls near; and a ball that outruns another.
TEST(LoneBall, at_rest_or_outrun) {
  Scene scene = box({0.0, 0.0}, {2.0, 2.0});
  scene.balls = {ball({1.0, 1.0}, {})};
  EXPECT_EQ(watched_run(scene, {.until = 1e9}).stop, Stop::no_events_left);
  Scene chase = open_space(1);
  chase.balls = {ball({0.0}, {1.0}), ball({2.0}, {std::nextafter(1.0, 2.0)})};
  EXPECT_EQ(watched_run(chase, {.until = 1e6}).stop, Stop::no_events_left);
}

// A chase that ends after 2^40 times its gap: the clock still knows when.
TEST(LoneBall, caught_up_with_in_the_end) {
  Scene chase = open_space(1);
  chase.balls = {ball({0.0}, {1.0 + 0x1p-40}), ball({2.0}, {1.0})};
  const Result result = watched_run(chase, {.until = 0x1p41});
  ASSERT_EQ(result.log.size(), 1u);
  EXPECT_EQ(result.log[0].time, 0x1p40);
}

}  // namespace
}  // namespace carom
