// --set: where values go, what text they keep, and how a wrong one is named.

#include <gtest/gtest.h>

#include "carom/core/rational.hpp"
#include "carom/scene/read.hpp"
#include "full_scene.hpp"

namespace carom {
namespace {

using testing::small_scene;

Scene with(const std::vector<Override>& overrides, const std::string& text = small_scene) {
  return read_scene(text, "test.toml", overrides);
}

// The one problem that an override causes.
std::string problem_of(const Override& o, const std::string& text = small_scene) {
  const std::vector<Problem> problems = testing::reading(text, {o}).problems;
  EXPECT_EQ(problems.size(), 1u) << o.key << "\n" << testing::listed(problems);
  return testing::listed(problems);
}

TEST(Override, replaces_numbers_vectors_and_elements) {
  const Scene s = with({{"ball.0.velocity", "[1.5, -0.1]"}, {"collision.restitution", "0.9"}, {"ball.1.position.0", "7"}});
  EXPECT_EQ(exact(s.balls[0].velocity[1]), Rational(-1, 10));
  EXPECT_EQ(exact(s.collision.restitution), Rational(9, 10));
  EXPECT_EQ(s.balls[1].position[0].value, 7.0);
  EXPECT_EQ(s.balls[1].position[1].value, 1.0);
}

TEST(Override, takes_as_a_string_what_is_no_toml) {
  const Scene s = with({{"ball.0.radius", "1/3"},
                        {"title", "two \"balls\"\tand \\ more"},
                        {"ball.1.mass", "inf"},
                        {"ball.1.name", "a = 1\nb = 2"}});
  EXPECT_EQ(exact(s.balls[0].radius), Rational(1, 3));
  EXPECT_EQ(s.title, "two \"balls\"\tand \\ more");
  EXPECT_EQ(s.balls[1].mass.value, std::numeric_limits<double>::infinity());
  EXPECT_EQ(s.balls[1].name, "a = 1\nb = 2");
}

TEST(Override, creates_tables_that_are_missing) {
  const Scene s = with({{"space.kind", "box"},
                        {"space.lower", "[0, 0]"},
                        {"space.upper", "[10, \"10/3\"]"},
                        {"material.ivory.restitution", "0.94"},
                        {"ball.0.material", "ivory"},
                        {"material.\"a.b\".restitution", "0.5"}});
  EXPECT_EQ(s.space.kind, SpaceKind::box);
  EXPECT_EQ(exact(s.space.upper[1]), Rational(10, 3));
  ASSERT_EQ(s.materials.size(), 2u);
  EXPECT_EQ(s.materials[0].name, "a.b");
  EXPECT_EQ(s.materials[1].restitution.value, 0.94);
}

TEST(Override, sets_whole_tables_and_arrays_of_them) {
  const Scene s = with({{"ball", "[{ position = [0.1, 0] }]"}, {"run", "{ events = 1_000 }"}});
  ASSERT_EQ(s.balls.size(), 1u);
  EXPECT_EQ(exact(s.balls[0].position[0]), Rational(1, 10));
  EXPECT_EQ(s.run.events, 1000);
  EXPECT_FALSE(s.run.until);
}

TEST(Override, the_last_one_wins_and_can_give_the_end_of_the_run) {
  const Scene s = with({{"run.until", "1"}, {"run.until", "0.1"}}, "[[ball]]\nposition = [0, 0]\n");
  EXPECT_EQ(exact(*s.run.until), Rational(1, 10));
}

TEST(Override, a_wrong_value_names_the_override_and_not_a_line) {
  EXPECT_EQ(problem_of({"ball.0.mass", "-1"}),
            "--set ball.0.mass=-1: ball.0.mass is -1 (a mass is above 0, or \"inf\").\n");
  EXPECT_NE(problem_of({"space.kind", "bxo"}).find("--set space.kind=bxo: space.kind is \"bxo\""), std::string::npos);
  EXPECT_NE(problem_of({"ball.0.velocty", "[1, 0]"}).find("Did you mean \"velocity\"?"), std::string::npos);
  EXPECT_NE(problem_of({"run", "3"}).find("--set run=3: run is an integer"), std::string::npos);
  EXPECT_NE(problem_of({"title", "\xff"}).find("--set title="), std::string::npos);
}

TEST(Override, what_it_breaks_elsewhere_has_the_line_of_the_file) {
  const std::vector<Problem> problems = testing::reading(small_scene, {{"dimension", "3"}}).problems;
  ASSERT_EQ(problems.size(), 3u) << testing::listed(problems);
  EXPECT_EQ(problems[0].line, 2);
  EXPECT_EQ(problems[1].line, 3);
  EXPECT_EQ(problems[2].line, 5);
}

TEST(Override, a_path_that_leads_nowhere_is_named) {
  for (const Override& o : std::vector<Override>{{"ball.2.mass", "1"},
                                                 {"ball.-1.mass", "1"},
                                                 {"ball.x.mass", "1"},
                                                 {"ball.99999999999999999999.mass", "1"},
                                                 {"ball.0.position.2", "1"},
                                                 {"run.until.x", "1"},
                                                 {"", "1"},
                                                 {".", "1"},
                                                 {"ball..mass", "1"},
                                                 {"ball.0.", "1"},
                                                 {"\"ball", "1"},
                                                 {"\"ball\"x", "1"},
                                                 {"a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a", "1"}}) {
    EXPECT_EQ(problem_of(o).rfind("--set " + o.key + "=" + o.value + ": ", 0), 0u) << o.key;
  }
  EXPECT_NE(problem_of({"ball.2.mass", "1"}).find("ball has 2 elements, numbered from 0"), std::string::npos);
}

}  // namespace
}  // namespace carom
