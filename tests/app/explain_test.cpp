// carom explain: what is composed, and what is not modelled.

#include "app/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace carom {
namespace {

using test::carom;
using test::Folder;
using testing::HasSubstr;

TEST(Explain, says_what_runs_and_what_is_left_out) {
  const Folder folder;
  folder.write("a.toml", test::head_on(2, "[output]\nevents = \"e.csv\"\n"));
  const test::Outcome o = carom(folder, {"explain", "a.toml", "--set", "collision.restitution=0.9"});
  EXPECT_EQ(o.status, 0);
  EXPECT_THAT(o.out, testing::AllOf(HasSubstr("2 balls and 4 walls"), HasSubstr("e = 0.9"), HasSubstr("gravity"),
                                    HasSubstr("rotation"), HasSubstr("inelastic collapse")));
  EXPECT_FALSE(std::filesystem::exists(folder.file("e.csv"))) << "nothing is run";
  EXPECT_THAT(carom(folder, {"explain", "a.toml"}).out, testing::Not(HasSubstr("inelastic collapse")));
}

TEST(Explain, prints_json) {
  const Folder folder;
  folder.write("a.toml", test::head_on(3));
  const auto j = nlohmann::json::parse(carom(folder, {"explain", "a.toml", "--json"}).out);
  EXPECT_EQ(j["balls"], 2);
  EXPECT_EQ(j["walls"], 6);
  EXPECT_FALSE(j["composition"]["reasons"].empty());
  EXPECT_FALSE(j["not_modelled"].empty());
}

// Two balls of radius 1/2 at speed 1: r/v = 1/2.
TEST(Explain, says_what_steps_and_engines_leave_out) {
  const Folder folder;
  folder.write("a.toml", test::head_on(2));
  EXPECT_THAT(carom(folder, {"explain", "a.toml"}).out,
              testing::AllOf(HasSubstr("r/v = 0.5,"), HasSubstr("by box2d"), HasSubstr("by chipmunk"),
                             HasSubstr("by bullet"), testing::Not(HasSubstr("parabola"))));
  EXPECT_THAT(carom(folder, {"explain", "a.toml", "--set", "motion.acceleration=[0,-1]"}).out, HasSubstr("parabola"));
  const auto j =
      nlohmann::json::parse(carom(folder, {"explain", "a.toml", "--json", "--set", "collision.law=\"merge\""}).out);
  EXPECT_THAT(j["not_by_steps"][0], HasSubstr("merge"));
  EXPECT_EQ(j["engines"].size(), 3u);
  for (const auto& engine : j["engines"]) EXPECT_FALSE(engine["not_represented"].empty());
}

// Two listed values times three runs at each.
TEST(Explain, says_what_an_ensemble_varies) {
  const Folder folder;
  folder.write("a.toml", test::head_on(2, "[ensemble]\ncount = 3\nseed = 7\n[[ensemble.vary]]\nkey = \"collision.restitution\"\n"
                                          "values = [0.5, 1]\n[[ensemble.vary]]\nkey = \"ball.0.radius\"\nfrom = 0.1\nto = 0.2\n"));
  EXPECT_THAT(carom(folder, {"explain", "a.toml"}).out,
              testing::AllOf(HasSubstr("6 runs by carom sweep"), HasSubstr("seed 7"), HasSubstr("collision.restitution: 0.5, 1"),
                             HasSubstr("ball.0.radius: drawn from 0.1 to 0.2")));
  folder.write("b.toml", test::head_on(2));
  EXPECT_THAT(carom(folder, {"explain", "b.toml"}).out, testing::Not(HasSubstr("Ensemble")));
}

TEST(Explain, refuses_a_wrong_scene) {
  const Folder folder;
  folder.write("a.toml", test::head_on(2));
  EXPECT_EQ(carom(folder, {"explain", "a.toml", "--set", "ball.0.radius=-1"}).status, 2);
  EXPECT_EQ(carom(folder, {"explain", "none.toml"}).status, 2);
}

}  // namespace
}  // namespace carom
