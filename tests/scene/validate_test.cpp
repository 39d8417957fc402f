// The rules for scenes made in code: the same as for files.

#include "carom/scene/validate.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "full_scene.hpp"

namespace carom {
namespace {

Scene good() {
  Scene s;
  BallSpec ball;
  ball.position = {0.0, 0.0};
  s.balls.push_back(ball);
  s.run.until = 1.0;
  return s;
}

void expect_one(const Scene& s, const std::string& words) {
  const std::vector<Problem> problems = testing::mistakes(validate(s));
  ASSERT_EQ(problems.size(), 1u) << testing::listed(problems);
  EXPECT_NE(problems[0].text().find(words), std::string::npos) << problems[0].text();
}

TEST(Validate, accepts_a_good_scene) { EXPECT_TRUE(validate(good()).empty()); }

TEST(Validate, uses_the_line_of_the_table) {
  Scene s = good();
  s.file = "made.toml";
  s.balls[0].mass = -2.5;
  s.balls[0].where.line = 14;
  EXPECT_EQ(testing::listed(validate(s)), "made.toml:14: ball.0.mass is -2.5 (a mass is above 0, or \"inf\").\n");
}

TEST(Validate, judges_numbers_that_no_file_could_hold) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  Scene s = good();
  s.balls[0].position[1] = nan;
  expect_one(s, "ball.0.position has the component nan");
  s = good();
  s.balls[0].radius = inf;
  expect_one(s, "ball.0.radius is inf");
  s = good();
  s.balls[0].mass = nan;
  expect_one(s, "ball.0.mass is nan");
  s = good();
  s.balls[0].mass = -inf;
  expect_one(s, "ball.0.mass is -inf");
  s = good();
  s.run.until = nan;
  expect_one(s, "run.until is nan");
  s = good();
  s.collision.restitution = nan;
  expect_one(s, "collision.restitution is nan");
}

TEST(Validate, finds_what_only_code_can_do) {
  Scene s = good();
  s.materials.resize(2);
  s.materials[0].name = s.materials[1].name = "ivory";
  expect_one(s, "material.ivory is given twice");
  s = good();
  s.materials.resize(1);
  expect_one(s, "a material has no name");
  s = good();
  s.dimension = 4;
  expect_one(s, "dimension is 4");
  s = good();
  s.lattices.resize(1);
  s.lattices[0].kind = LatticeKind::rack;
  s.lattices[0].apex = {1.0, 1.0};
  s.lattices[0].radius = 0.5;
  s.lattices[0].count = 3;
  expect_one(s, "lattice.0.count is 3");
}

TEST(Validate, finds_everything_at_once) {
  Scene s = good();
  s.balls[0].radius = -1;
  s.balls[0].mass = 0;
  s.run.until.reset();
  s.space.kind = SpaceKind::box;
  s.balls[0].material = "ivory";
  EXPECT_EQ(testing::mistakes(validate(s)).size(), 5u) << testing::listed(validate(s));
}

TEST(Validate, refuses_an_empty_scene) {
  const std::string all = testing::listed(validate(Scene()));
  EXPECT_NE(all.find("the scene has no balls"), std::string::npos);
  EXPECT_NE(all.find("the run has no end"), std::string::npos);
}

}  // namespace
}  // namespace carom
