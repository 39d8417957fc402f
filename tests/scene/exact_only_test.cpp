// What fixed steps and game engines refuse is named with its line; all else is left to them.

#include "carom/scene/exact_only.hpp"

#include <gtest/gtest.h>

#include "full_scene.hpp"

namespace carom {
namespace {

std::vector<Problem> refused(const std::string& text) {
  const auto reading = testing::reading(testing::small_scene + text);
  EXPECT_TRUE(reading.problems.empty()) << text;
  return exact_only(reading.scene);
}

TEST(ExactOnly, names_the_field_and_each_wall_that_swings) {
  const std::string floor = "[[wall]]\nkind = \"plane\"\npoint = [0, 0]\nnormal = [0, 1]\n";
  EXPECT_TRUE(refused("").empty());
  EXPECT_TRUE(refused(floor + "velocity = [0, 1]\n").empty());
  EXPECT_TRUE(refused("[motion]\nmagnetic = 0\n").empty()) << "switched off";
  const auto field = refused("[motion]\nmagnetic = -1.5\n");
  ASSERT_EQ(field.size(), 1u);
  EXPECT_EQ(field[0].what, "motion.magnetic");
  EXPECT_EQ(field[0].line, 8);
  const auto swings = refused(floor + "oscillation = { amplitude = [0, 0.1] }\n" + floor + "oscillation = { amplitude = [1, 0], omega = 2 }\n");
  ASSERT_EQ(swings.size(), 2u);
  EXPECT_EQ(swings[1].what, "wall.oscillation");
  EXPECT_EQ(swings[1].line, 13);
}

}  // namespace
}  // namespace carom
