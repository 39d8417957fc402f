// What a scene with balls that grow may ask for, and what it may not: every problem by name and line.

#include <gtest/gtest.h>

#include <string>

#include "carom/scene/growing.hpp"
#include "full_scene.hpp"

namespace carom {
namespace {

const std::string gas = "[[gas]]\ncount = 20\nradius = 0.1\npacking_fraction = 0.2\nradius_growth = \"1/100\"\n";

std::string problems(const std::string& text) { return testing::listed(testing::reading(text).problems); }

TEST(GrowthRules, accept_a_gas_that_grows_until_it_is_packed) {
  const auto reading =
      testing::reading(gas + "[run]\nuntil_packing = 0.8\nuntil_reduced_pressure = 1e6\nrescale_every = 2_000\n");
  EXPECT_EQ(testing::listed(reading.problems), "");
  EXPECT_TRUE(balls_grow(reading.scene));
  EXPECT_EQ(reading.scene.gases[0].radius_growth, 0.01);
  EXPECT_EQ(*reading.scene.run.until_packing, 0.8);
  EXPECT_EQ(*reading.scene.run.until_reduced_pressure, 1e6);
  EXPECT_EQ(*reading.scene.run.rescale_every, 2000);
}

TEST(GrowthRules, refuse_what_has_no_meaning_without_growth) {
  for (const char* key : {"until_packing = 0.8", "until_reduced_pressure = 10", "rescale_every = 5"}) {
    const std::string found = problems(testing::small_scene + key + "\n");
    EXPECT_NE(found.find("has no meaning here (no ball grows)"), std::string::npos) << key << '\n' << found;
  }
}

TEST(GrowthRules, refuse_values_out_of_range) {
  for (const char* key : {"until_packing = 0", "until_packing = 1", "until_reduced_pressure = 1", "rescale_every = 0"}) {
    const std::string found = problems(gas + "[run]\nevents = 5\n" + key + "\n");
    EXPECT_EQ(found.find("test.toml:8: run." + std::string(key).substr(0, 6)), 0u) << key << '\n' << found;
  }
  EXPECT_NE(
      problems("[[ball]]\nposition = [0, 0]\nradius_growth = -1\n[run]\nevents = 5\n").find("a radius grows, or stays"),
      std::string::npos);
}

TEST(GrowthRules, refuse_by_name_what_is_not_built_beside_growth) {
  for (const char* text :
       {"[collision]\nlaw = \"merge\"\n", "[collision]\nlaw = \"stick\"\n", "[collision]\nsimultaneous = \"symmetric\"\n",
        "[collision]\nregularise = \"rest\"\n", "[motion]\nacceleration = [0, -1]\n", "[observe]\npressure = true\n"}) {
    const std::string found = problems(text + gas + "[run]\nevents = 5\n");
    EXPECT_NE(found.find("with balls that grow: not built yet"), std::string::npos) << text << '\n' << found;
  }
}

}  // namespace
}  // namespace carom
