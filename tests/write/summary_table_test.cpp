#include "carom/write/summary_table.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace carom {
namespace {

using testing::HasSubstr;
using testing::Not;

RunReport report() {
  RunReport r;
  r.summary.title = "A title";
  r.summary.balls = 2;
  r.summary.time = 10.0;
  r.summary.events = {1, 3, 0, 2};
  r.summary.energy = {5.0, 5.0, 0.0, 0.0, 0.0};
  r.summary.momentum = {{1.0, 0.0}, {-1.0, 0.5}, std::nullopt};
  r.summary.angular_momentum = {{2.0}, {2.0}, 0.0};
  r.seconds = 2.0;
  return r;
}

TEST(SummaryTable, says_what_happened) {
  const std::string text = summary_table(report());
  EXPECT_THAT(text, HasSubstr("until, at time 10"));
  EXPECT_THAT(text, HasSubstr("4: 1 of two balls, 3 with walls; 2 ties"));
  EXPECT_THAT(text, HasSubstr("not conserved here (walls"));
  EXPECT_THAT(text, HasSubstr("2 collisions/s"));
}

TEST(SummaryTable, counts_the_energy_error_in_ulps_of_the_initial_energy) {
  RunReport r = report();
  EXPECT_THAT(summary_table(r), HasSubstr("0, 0 ulp of the initial energy"));
  r.summary.energy.final = 5.0 + 8 * std::numeric_limits<double>::epsilon();  // two ulps: 5 lies in [4, 8)
  EXPECT_THAT(summary_table(r), HasSubstr(", 2 ulp of the initial energy"));
  // 5 -> 2 with 3 + 4 eps dissipated: one ulp too much, which a sum in one double would lose or round.
  r.summary.energy = {5.0, 2.0, 3.0 + 4 * std::numeric_limits<double>::epsilon(), 0.0, 0.0};
  EXPECT_THAT(summary_table(r), HasSubstr(", 1 ulp of the initial energy"));
}

TEST(SummaryTable, shows_the_balls_that_it_is_given) {
  RunReport r = report();
  EXPECT_THAT(summary_table(r), Not(HasSubstr("vx")));
  BallState ball;
  ball.index = 7;
  ball.name = "cue";
  ball.position = {0.25, -3.0};
  ball.velocity = {1.5, 2.5};
  r.final = {ball};
  EXPECT_THAT(summary_table(r), testing::ContainsRegex("ball +name +x +y +vx +vy\n +7 +cue +0.25 +-3 +1.5 +2.5\n"));
}

TEST(SummaryTable, names_the_files_that_were_written) {
  RunReport r = report();
  EXPECT_THAT(summary_table(r), Not(HasSubstr("wrote")));
  r.files = {"out/events.csv", "out/trajectory.h5"};
  EXPECT_THAT(summary_table(r), HasSubstr("  wrote             out/events.csv\n                    out/trajectory.h5\n"));
}

TEST(SummaryTable, is_plain_unless_colour_is_wanted) {
  EXPECT_THAT(summary_table(report()), Not(HasSubstr("\x1b")));
  RunReport warned = report();
  EXPECT_THAT(summary_table(warned, Colour::on), testing::AllOf(HasSubstr("\x1b[1mA title"), Not(HasSubstr("\x1b[31m"))));
  warned.summary.exactness.clamped = 1;
  EXPECT_THAT(summary_table(warned, Colour::on), HasSubstr("\x1b[31m1 clamped"));
}

}  // namespace
}  // namespace carom
