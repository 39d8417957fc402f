#include "command_line.hpp"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace carom::app {
namespace {

using testing::ElementsAre;

TEST(CommandLine, reads_every_option_of_run) {
  const Command c = parse({"run", "--set", "a=1", "a.toml", "--set", "ball.0.velocity=[1,0]", "--until", "1/3", "--events",
                           "7", "--out", "d", "--json", "--final", "--quiet"});
  const auto& run = std::get<RunOptions>(c);
  EXPECT_EQ(run.scene.file, "a.toml");
  EXPECT_THAT(run.scene.set, ElementsAre("a=1", "ball.0.velocity=[1,0]"));
  EXPECT_EQ(run.scene.until, "1/3");
  EXPECT_EQ(run.scene.events, "7");
  EXPECT_EQ(run.precision, "double");
  EXPECT_EQ(run.out, "d");
  EXPECT_TRUE(run.json && run.final && run.quiet);
}

TEST(CommandLine, keeps_negative_numbers_and_brackets) {
  const Command c = parse({"run", "a.toml", "--until", "-5", "--set", "x=[[1, 2], [3]]", "--set", "y=-1"});
  EXPECT_EQ(std::get<RunOptions>(c).scene.until, "-5");
  EXPECT_THAT(std::get<RunOptions>(c).scene.set, ElementsAre("x=[[1, 2], [3]]", "y=-1"));
}

TEST(CommandLine, reads_the_other_commands) {
  EXPECT_TRUE(std::get<ExplainOptions>(parse({"explain", "a.toml", "--json"})).json);
  EXPECT_TRUE(std::get<NewOptions>(parse({"new", "--list"})).list);
  EXPECT_EQ(std::get<NewOptions>(parse({"new", "a", "--out", "b"})).out, "b");
}

TEST(CommandLine, reads_every_option_of_compare) {
  const Command c = parse({"compare", "a.toml", "--dt", "1e-2,1/300", "--method", "swept,penalty:steps=10", "--engine",
                           "box2d:continuous", "--until", "3", "--set", "a=1", "--out", "d", "--json"});
  const auto& compare = std::get<CompareOptions>(c);
  EXPECT_EQ(compare.scene.file, "a.toml");
  EXPECT_EQ(compare.dt, "1e-2,1/300");
  EXPECT_EQ(compare.methods, "swept,penalty:steps=10");
  EXPECT_EQ(compare.engines, "box2d:continuous");
  EXPECT_EQ(compare.scene.until, "3");
  EXPECT_THAT(compare.scene.set, ElementsAre("a=1"));
  EXPECT_EQ(compare.out, "d");
  EXPECT_TRUE(compare.json);
}

TEST(CommandLine, answers_where_there_is_nothing_to_do) {
  EXPECT_EQ(std::get<Answer>(parse({})).status, ExitStatus::done);
  EXPECT_EQ(std::get<Answer>(parse({"--version"})).status, ExitStatus::done);
  EXPECT_EQ(std::get<Answer>(parse({"run", "--help"})).status, ExitStatus::done);
  EXPECT_EQ(std::get<Answer>(parse({"run"})).status, ExitStatus::wrong_input);
}

TEST(CommandLine, sends_answers_to_the_right_stream) {
  std::ostringstream out, err;
  const Console console{out, err};
  EXPECT_EQ(perform(Answer{ExitStatus::done, "help"}, console), ExitStatus::done);
  EXPECT_EQ(perform(Answer{ExitStatus::wrong_input, "wrong"}, console), ExitStatus::wrong_input);
  EXPECT_EQ(out.str(), "help");
  EXPECT_EQ(err.str(), "wrong");
}

}  // namespace
}  // namespace carom::app
