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

TEST(Explain, refuses_a_wrong_scene) {
  const Folder folder;
  folder.write("a.toml", test::head_on(2));
  EXPECT_EQ(carom(folder, {"explain", "a.toml", "--set", "ball.0.radius=-1"}).status, 2);
  EXPECT_EQ(carom(folder, {"explain", "none.toml"}).status, 2);
}

}  // namespace
}  // namespace carom
