// Ensembles: the values of each run, what is drawn, and what is refused.

#include "carom/scene/ensemble.hpp"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "full_scene.hpp"

namespace carom {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<std::string> texts(const std::vector<Override>& set) {
  std::vector<std::string> list;
  for (const Override& o : set) list.push_back(o.key + "=" + o.value);
  return list;
}

const std::string scene = "[[ball]]\nposition = [0.5, 0.5]\nvelocity = [3, 4]\nradius = 0.125\n[run]\nevents = 10\n";

EnsembleSpec spec(const std::vector<std::string>& vary, std::int64_t count = 1) {
  EnsembleSpec e;
  for (const std::string& v : vary) e.vary.push_back(parse_vary(v));
  e.count = count;
  return e;
}

Ensemble ensemble(const std::vector<std::string>& vary, std::int64_t count = 1, const std::string& text = scene) {
  return Ensemble({text, "test.toml", {}}, spec(vary, count));
}

TEST(Ensemble, walks_a_range_in_steps_that_come_out_as_written) {
  const Ensemble e = ensemble({"ball.0.radius=0.1:0.4:4"});
  ASSERT_EQ(e.runs(), 4);
  for (std::int64_t k = 0; k < 4; ++k)
    EXPECT_THAT(texts(e.member(k).set), ElementsAre("ball.0.radius=0." + std::to_string(k + 1)));
  EXPECT_EQ(e.member(2).scene.balls[0].radius.value, 0.3);
}

// The last key is the fastest; more runs at each combination come after all combinations.
TEST(Ensemble, combines_each_with_each) {
  const Ensemble e = ensemble({"ball.0.mass=[1, 2]", "ball.0.name=[\"a\", \"b\", \"c\"]"}, 2);
  EXPECT_EQ(e.runs(), 12);
  EXPECT_EQ(e.combinations(), 6);
  EXPECT_THAT(texts(e.member(0).set), ElementsAre("ball.0.mass=1", "ball.0.name=\"a\""));
  EXPECT_THAT(texts(e.member(1).set), ElementsAre("ball.0.mass=1", "ball.0.name=\"b\""));
  EXPECT_THAT(texts(e.member(5).set), ElementsAre("ball.0.mass=2", "ball.0.name=\"c\""));
  EXPECT_EQ(texts(e.member(6).set), texts(e.member(0).set));
  EXPECT_EQ(e.member(4).scene.balls[0].name, "b");
}

TEST(Ensemble, zips_lists_when_told_to) {
  EnsembleSpec z = spec({"ball.0.mass=[1, 2]", "ball.0.radius=0.1:0.2:2"});
  z.combine = Combine::zip;
  const Ensemble e({scene, "test.toml", {}}, z);
  EXPECT_EQ(e.runs(), 2);
  EXPECT_THAT(texts(e.member(1).set), ElementsAre("ball.0.mass=2", "ball.0.radius=0.2"));
}

TEST(Ensemble, draws_from_seed_run_and_key_alone) {
  const Ensemble one = ensemble({"ball.0.radius=0.1:0.2"}, 100);
  const Ensemble two = ensemble({"ball.0.mass=1:2", "ball.0.radius=0.1:0.2"}, 50);
  EXPECT_EQ(one.member(7).set[0].value, two.member(7).set[1].value) << "another key changes nothing";
  EXPECT_NE(one.member(7).set[0].value, one.member(8).set[0].value);
  EnsembleSpec other = spec({"ball.0.radius=0.1:0.2"}, 100);
  other.seed = 2;
  EXPECT_NE(one.member(7).set[0].value, Ensemble({scene, "test.toml", {}}, other).member(7).set[0].value);
}

// Uniform on [a, b]: mean (a + b)/2, variance (b - a)^2/12, so that 4000 draws have a mean within 5 of its standard errors.
TEST(Ensemble, draws_uniformly_from_a_range) {
  const Ensemble e = ensemble({"ball.0.radius=1:3"}, 4000);
  double sum = 0, least = 9, most = 0;
  for (std::int64_t i = 0; i < 4000; ++i) {
    const double x = e.member(i).scene.balls[0].radius;
    sum += x;
    least = std::min(least, x);
    most = std::max(most, x);
  }
  EXPECT_NEAR(sum / 4000, 2.0, 5 * 2 / std::sqrt(12.0 * 4000));
  EXPECT_GE(least, 1.0);
  EXPECT_LE(most, 3.0);
  EXPECT_LT(least, 1.01);
  EXPECT_GT(most, 2.99);
}

// A direction keeps the speed, 5; cos and cos 2 of its angle have mean 0 and variance 1/2.
TEST(Ensemble, draws_directions_at_the_speed_of_the_scene) {
  const Ensemble e = ensemble({"ball.0.velocity=random"}, 4000);
  double cosine = 0, sine = 0, twice = 0;
  for (std::int64_t i = 0; i < 4000; ++i) {
    const Coordinates v = e.member(i).scene.balls[0].velocity;
    ASSERT_NEAR(std::hypot(v[0].value, v[1].value), 5.0, 5e-15);
    cosine += v[0] / 5;
    sine += v[1] / 5;
    twice += (v[0] * v[0] - v[1] * v[1]) / 25;
  }
  const double bound = 5 * std::sqrt(0.5 * 4000);
  EXPECT_LT(std::abs(cosine), bound);
  EXPECT_LT(std::abs(sine), bound);
  EXPECT_LT(std::abs(twice), bound);
}

// On the unit sphere each component is uniform: mean 0, variance 1/3 (Archimedes).
TEST(Ensemble, draws_directions_in_space) {
  const std::string text = "dimension = 3\n[[ball]]\nposition = [0, 0, 0]\nvelocity = [0, 0, 2]\n[run]\nevents = 1\n";
  const Ensemble e = ensemble({"ball.0.velocity=random"}, 3000, text);
  std::array<double, 3> first{}, second{};
  for (std::int64_t i = 0; i < 3000; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const double n = e.member(i).scene.balls[0].velocity[k] / 2;
      first[k] += n / 3000;
      second[k] += n * n / 3000;
    }
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(first[k], 0.0, 5 / std::sqrt(3.0 * 3000));
    EXPECT_NEAR(second[k], 1.0 / 3, 5 * std::sqrt(4.0 / 45 / 3000));
  }
}

// An L of three unit squares: a third of the places in each, none in the fourth square of the box around it.
TEST(Ensemble, draws_places_within_an_outline) {
  const std::string text =
      scene + "[[wall]]\nkind = \"polygon\"\nvertices = [[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]]\n";
  const Ensemble e = ensemble({"ball.0=random"}, 3000, text);
  EXPECT_TRUE(e.places());
  int corner = 0, right = 0, upper = 0;
  for (std::int64_t i = 0; i < 3000; ++i) {
    const Ensemble::Member m = e.member(i);
    const Coordinates& x = m.scene.balls[0].position;
    const bool a = x[0] > 1, b = x[1] > 1;
    ASSERT_FALSE(a && b);
    ++(a ? right : b ? upper : corner);
    ASSERT_EQ(m.set[0].key + m.set[1].key, "ball.0.positionball.0.velocity");
  }
  const double bound = 5 * std::sqrt(3000 * 2.0 / 9);
  for (const int n : {corner, right, upper}) EXPECT_NEAR(n, 1000, bound);
}

TEST(Ensemble, draws_anew_for_another_attempt) {
  const Ensemble e = ensemble({"ball.0=random"}, 2, scene + "[space]\nkind = \"box\"\nlower = [0, 0]\nupper = [1, 1]\n");
  EXPECT_NE(e.member(0, 0).set[0].value, e.member(0, 1).set[0].value);
  EXPECT_EQ(e.member(0, 1).set[0].value, e.member(0, 1).set[0].value);
}

// The same scene, from the text and the values of the row, as carom run makes it.
TEST(Ensemble, a_run_is_what_its_values_make_of_the_scene) {
  const std::string text = scene + "[space]\nkind = \"box\"\nlower = [0, 0]\nupper = [1, 1]\n";
  const Ensemble::Member m = ensemble({"ball.0=random", "ball.0.mass=1:2"}, 5, text).member(3);
  const Scene again = read_scene(text, "test.toml", m.set);
  EXPECT_EQ(again.balls[0].position, m.scene.balls[0].position);
  EXPECT_EQ(again.balls[0].velocity, m.scene.balls[0].velocity);
  EXPECT_EQ(again.balls[0].mass.value, m.scene.balls[0].mass.value);
}

TEST(Ensemble, is_read_from_the_scene) {
  const scene_text::Reading r = testing::reading(scene + R"(
[ensemble]
count = 3
seed = 9
combine = "zip"
vary = [
  { key = "ball.0.mass", values = [1, 2.50, "1/3"] },
  { key = "ball.0.velocity", values = [[1, 0], [0, -1e-3], [1, 1]] },
  { key = "ball.0.radius", from = 0.1, to = 0.2 },
  { key = "run.seed" },
])");
  ASSERT_TRUE(r.problems.empty()) << testing::listed(r.problems);
  const EnsembleSpec& e = *r.scene.ensemble;
  EXPECT_EQ(e.count, 3);
  EXPECT_EQ(e.seed, 9U);
  EXPECT_EQ(e.combine, Combine::zip);
  ASSERT_EQ(e.vary.size(), 4U);
  EXPECT_THAT(e.vary[0].values, ElementsAre("1", "2.50", "\"1/3\"")) << "numbers as they are written";
  EXPECT_THAT(e.vary[1].values, ElementsAre("[1, 0]", "[0, -1e-3]", "[1, 1]"));
  EXPECT_EQ(e.vary[2].to->value, 0.2);
}

struct Wrong {
  std::string text, says;
};

TEST(Ensemble, refuses_what_has_no_meaning) {
  for (const Wrong& w : {Wrong{"count = 0", "at least one run"},
                         Wrong{"vary = [{ key = \"a\" }]", "drawn by themselves"},
                         Wrong{"vary = [{ from = 1, to = 2 }]", "ensemble.vary.0.key is missing"},
                         Wrong{"vary = [{ key = \"a\", from = 1 }]", "ensemble.vary.0.to is missing"},
                         Wrong{"vary = [{ key = \"a\", from = 1, to = 2, steps = 1 }]", "2 steps or more"},
                         Wrong{"vary = [{ key = \"a\", from = 1, to = 2, values = [3] }]", "one of them"},
                         Wrong{"vary = [{ key = \"a\", values = [] }]", "an array of values is needed"},
                         Wrong{"vary = [{ key = \"ensemble.seed\", values = [3] }]", "does not vary itself"},
                         Wrong{"combine = \"zip\"\nvary = [{ key = \"a\", values = [3] }, { key = \"b\", values = [3, 4] }]",
                               "equally long"},
                         Wrong{"vary = [{ key = \"a\", from = 0, to = 1, steps = 2_000_000 }, { key = \"b\", from = 0, to = 1, steps "
                               "= 2_000_000 }]",
                               "more than 1099511627776 runs"}}) {
    const std::string problems = testing::listed(testing::reading(scene + "[ensemble]\n" + w.text + "\n").problems);
    EXPECT_THAT(problems, HasSubstr(w.says)) << w.text;
    EXPECT_THAT(problems, HasSubstr("test.toml:")) << w.text;
  }
  for (const char* text : {"a", "=1", "a=1", "a=[]", "a=1:2:1", "a=1:2:x", "a=x:2", "a=1:2:3:4", "a=random"})
    EXPECT_THROW(static_cast<void>(parse_vary(text)), InputError) << text;
  EXPECT_THROW(ensemble({}), InputError) << "nothing to vary";
  EXPECT_THROW(static_cast<void>(ensemble({"ball.0=random"}).member(0)), InputError) << "an open space without walls";
  EXPECT_THROW(static_cast<void>(ensemble({"ball.5.velocity=random"}).member(0)), InputError);
}

}  // namespace
}  // namespace carom
