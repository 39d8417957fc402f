// Two lists of meetings, made by hand.

#include "carom/observe/meeting.hpp"

#include <gtest/gtest.h>

namespace carom {
namespace {

Meeting balls(double time, std::uint32_t a, std::uint32_t b) { return {time, EventKind::ball_ball, a, b, 1.0}; }
Meeting wall(double time, std::uint32_t ball, std::uint32_t wall) { return {time, EventKind::ball_wall, ball, wall, 1.0}; }

const Meetings exact{balls(1.0, 0, 1), wall(2.0, 1, 0), balls(3.0, 1, 2), wall(3.5, 1, 0), balls(4.0, 0, 1)};

TEST(Match, finds_nothing_between_equal_lists) {
  const Tally t = match(exact, exact, {10.0});
  EXPECT_EQ(t.missed, 0);
  EXPECT_EQ(t.missed_pairs, 0);
  EXPECT_EQ(t.spurious, 0);
  EXPECT_EQ(t.swapped, 0);
}

// (1, 2) never meets; (0, 1) meets once instead of twice: two meetings are missed, by one pair altogether.
TEST(Match, counts_missed_meetings_and_pairs) {
  const Tally t = match(exact, {balls(1.1, 0, 1), wall(2.1, 1, 0), wall(3.6, 1, 0)}, {10.0});
  EXPECT_EQ(t.missed, 2);
  EXPECT_EQ(t.missed_pairs, 1);
  EXPECT_EQ(t.spurious, 0);
}

// (0, 2) never meets in the exact run, and (1, wall 0) only twice.
TEST(Match, counts_spurious_meetings) {
  Meetings here = exact;
  here.push_back(balls(5.0, 0, 2));
  here.push_back(wall(6.0, 1, 0));
  EXPECT_EQ(match(exact, here, {10.0}).spurious, 2);
  EXPECT_EQ(match(exact, here, {10.0}).missed, 0);
  EXPECT_EQ(match(exact, here, {5.5}).spurious, 1) << "what comes after the end is not judged";
}

// Ball 1: wall at 2 and ball 2 at 3 in the exact run; here the other way round, within one step or not.
TEST(Match, counts_inversions_of_a_ball) {
  const Meetings here{balls(1.0, 0, 1), balls(3.0, 1, 2), wall(3.0, 1, 0), wall(3.5, 1, 0), balls(4.0, 0, 1)};
  const Tally t = match(exact, here, {10.0});
  EXPECT_EQ(t.swapped, 1);
  EXPECT_EQ(t.missed + t.spurious, 0) << "all of them came";
}

// The meetings (0, 1) and (2, 3) share no ball: their order is nobody's.
TEST(Match, order_of_strangers_does_not_count) {
  EXPECT_EQ(match({balls(1, 0, 1), balls(2, 2, 3)}, {balls(2, 2, 3), balls(2, 0, 1)}, {10.0}).swapped, 0);
}

// Ball 1 meets 0 and 2 at one moment: mechanics gives no order. A fixed ball 1 has none to be disturbed.
TEST(Match, ties_and_obstacles_have_no_order) {
  const Meetings tie{balls(1, 0, 1), balls(1, 1, 2)}, turned{balls(1, 1, 2), balls(1, 0, 1)};
  EXPECT_EQ(match(tie, turned, {10.0}).swapped, 0);
  const Meetings apart{balls(1, 0, 1), balls(2, 1, 2)};
  EXPECT_EQ(match(apart, turned, {10.0}).swapped, 1);
  EXPECT_EQ(match(apart, turned, {10.0}, {false, true}).swapped, 0);
}

// A meeting of the exact run just before the end may come a little later, and one here may be due a little later.
TEST(Match, allows_for_what_is_late_or_early_at_the_end) {
  const Meetings due{balls(1.0, 0, 1)}, late{balls(1.2, 0, 1)};
  EXPECT_EQ(match(due, late, {1.1, 0.0}).missed, 1);
  EXPECT_EQ(match(due, late, {1.1, 0.2}).missed, 0);
  EXPECT_EQ(match(late, due, {1.1, 0.0, 0.0}).spurious, 1);
  EXPECT_EQ(match(late, due, {1.1, 0.0, 0.2}).spurious, 0);
}

// Numbers of balls and of walls are different things.
TEST(Match, a_wall_is_no_ball) {
  const Tally t = match({balls(1, 0, 1)}, {wall(1, 0, 1)}, {10.0});
  EXPECT_EQ(t.missed, 1);
  EXPECT_EQ(t.spurious, 1);
}

}  // namespace
}  // namespace carom
