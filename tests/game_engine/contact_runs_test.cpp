#include "game_engine/contact_runs.hpp"

#include <gtest/gtest.h>

namespace carom::game_engine {
namespace {

class Runs : public testing::Test {
 protected:
  std::vector<StepContact> step(ContactRuns& runs) {
    std::vector<StepContact> found;
    ++steps_;
    runs.finish_step(layout_, 0.5 * static_cast<double>(steps_), steps_, [&](const StepContact& c) { found.push_back(c); });
    return found;
  }
  Layout layout_;
  std::int64_t steps_ = 0;
  const ContactKey pair_{EventKind::ball_ball, 1, 4, 0}, wall_{EventKind::ball_wall, 1, 0, 2};
};

TEST_F(Runs, count_the_first_impulse_alone) {
  ContactRuns runs(RunEnd::silence);
  runs.touch(pair_, 0.1, 0.0);
  EXPECT_EQ(step(runs).at(0).impulse, 0);
  runs.touch(pair_, 0.2, 3.0);
  EXPECT_EQ(step(runs).at(0).impulse, 3);
  runs.touch(pair_, 0.1, 2.0);
  EXPECT_EQ(step(runs).at(0).impulse, 0);
}

TEST_F(Runs, end_in_a_step_without_contact) {
  ContactRuns runs(RunEnd::silence);
  runs.touch(pair_, 0.0, 3.0);
  (void)step(runs);
  EXPECT_TRUE(step(runs).empty());
  runs.touch(pair_, 0.0, 2.0);
  EXPECT_EQ(step(runs).at(0).impulse, 2);
}

TEST_F(Runs, end_by_the_word_of_an_engine_that_gives_it) {
  ContactRuns runs(RunEnd::word);
  runs.touch(pair_, 0.0, 3.0);
  (void)step(runs);
  EXPECT_TRUE(step(runs).empty());  // asleep
  runs.touch(pair_, 0.0, 2.0);
  EXPECT_EQ(step(runs).at(0).impulse, 0);
  runs.end(pair_);
  runs.touch(pair_, 0.0, 2.0);
  EXPECT_EQ(step(runs).at(0).impulse, 2);
}

TEST_F(Runs, can_be_two_of_a_pair_in_one_step) {
  ContactRuns runs(RunEnd::word);
  runs.touch(pair_, 0.0, 3.0);
  runs.end(pair_);
  runs.touch(pair_, 0.0, 2.0);
  const auto found = step(runs);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].impulse, 3);
  EXPECT_EQ(found[1].impulse, 2);
}

TEST_F(Runs, sum_what_one_step_gives_and_keep_its_order) {
  ContactRuns runs(RunEnd::silence);
  runs.touch(wall_, 0.1, 1.0);
  runs.touch(pair_, 0.3, 0.0);
  runs.touch(wall_, 0.05, 1.5);
  const auto found = step(runs);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].kind, EventKind::ball_wall);
  EXPECT_EQ(found[0].impulse, 2.5);
  EXPECT_EQ(found[0].overlap, 0.1);
  EXPECT_EQ(found[0].feature, 2);
  EXPECT_EQ(found[1].partner, 4U);
  EXPECT_EQ(found[1].step, 1);
  EXPECT_EQ(found[1].time, 0.5);
}

// A gap before the contact is no overlap; lengths times 2^-3 and masses times 2^-1 are the user's.
TEST_F(Runs, speak_in_the_users_units) {
  layout_.length = 3;
  layout_.mass = 1;
  ContactRuns runs(RunEnd::silence);
  runs.touch(pair_, -0.5, 16.0);
  EXPECT_EQ(step(runs).at(0).overlap, 0);
  runs.touch(wall_, 0.5, 16.0);
  const StepContact found = step(runs).at(0);
  EXPECT_EQ(found.overlap, 0.0625);
  EXPECT_EQ(found.impulse, 1);
}

}  // namespace
}  // namespace carom::game_engine
