// carom check where contacts are simultaneous, and the horizon that it reports.

#include "app/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace carom {
namespace {

using nlohmann::json;
using test::carom;
using test::Folder;

/// Three touching balls in a row on a line, hit by a fourth; the middle one has mass m.
std::string row(const std::string& m, const std::string& rule) {
  std::string text = "dimension = 1\n[collision]\nsimultaneous = \"" + rule + "\"\n[[ball]]\nposition = [-3]\nvelocity = [1]\n";
  for (const char* x : {"0", "1", "2"})
    text += std::string("[[ball]]\nposition = [") + x + "]\nmass = " + (*x == '1' ? m : "1") + "\n";
  return text + "[run]\nuntil = 4\n";
}

json checked(const Folder& folder, const std::string& scene) {
  folder.write("row.toml", scene);
  const test::Outcome o = carom(folder, {"check", "row.toml", "--json"});
  EXPECT_EQ(o.status, 0) << o.err;
  return json::parse(o.out);
}

// Equal masses pass the impulse on under both rules. With a heavy one in the middle pair by pair is not all at once.
TEST(CheckRules, says_where_they_part) {
  const Folder folder;
  for (const char* rule : {"sequential", "symmetric"}) {
    const json equal = checked(folder, row("1", rule));
    EXPECT_EQ(equal["simultaneous"]["ties"], 2) << rule;
    EXPECT_TRUE(equal["simultaneous"]["compared"].get<bool>());
    EXPECT_TRUE(equal["simultaneous"]["rules_differ"].is_null());
  }
  // Between two ticks nothing is simultaneous, and nothing is compared.
  const json apart = checked(folder, "[[ball]]\nposition = [0, 0]\nvelocity = [1, 0]\n[[ball]]\nposition = [3, 0]\n[run]\nuntil = 5\n");
  EXPECT_FALSE(apart["simultaneous"]["compared"].get<bool>());

  // Hit from both sides at one moment: one after the other, the second hit is not the mirror image of the first.
  const json both = checked(folder,
                            "[[ball]]\nposition = [0, 0]\nmass = 3\n[[ball]]\nposition = [-3, 0]\nvelocity = [1, 0]\n"
                            "[[ball]]\nposition = [3, 0]\nvelocity = [-1, 0]\n[run]\nuntil = 5\n");
  ASSERT_FALSE(both["simultaneous"]["rules_differ"].is_null());
  EXPECT_EQ(both["simultaneous"]["rules_differ"]["time"], 2.0);
}

TEST(CheckRules, horizon_is_part_of_the_report) {
  const Folder folder;
  const json j = checked(folder, "[space]\nkind = \"box\"\nlower = [0, 0]\nupper = [10, 10]\n[[gas]]\ncount = 20\npacking_fraction = 0.3\n"
                                 "[run]\nevents = 2000\n");
  ASSERT_TRUE(j["horizon"]["event"].is_number());
  EXPECT_GT(j["horizon"]["event"], 50);
  EXPECT_GT(j["horizon"]["time"], 0.0);
  EXPECT_GT(j["horizon"]["digits_per_collision"], 0.0);
  EXPECT_LE(j["horizon"]["percent"]["event"], j["horizon"]["event"]);
  EXPECT_EQ(j["horizon"]["precision"], 50);
  EXPECT_TRUE(j["no_horizon"].is_null());
}

// Balls come to rest in double only: there is no run in high precision to compare with, and the report says so.
TEST(CheckRules, without_a_horizon_it_says_why) {
  const Folder folder;
  const json j = checked(folder, "[motion]\nacceleration = [0, -1]\n[collision]\nrestitution = 0.5\nregularise = \"rest\"\n"
                                 "[[wall]]\nkind = \"plane\"\npoint = [0, 0]\nnormal = [0, 1]\n[[ball]]\nposition = [0, 2]\n"
                                 "[run]\nuntil = 10\n");
  EXPECT_TRUE(j["horizon"].is_null());
  EXPECT_NE(j["no_horizon"].get<std::string>().find("rest"), std::string::npos);
}

}  // namespace
}  // namespace carom
