// carom orbit: cycles known in closed form, from starts beside them.

#include "app/program.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace carom {
namespace {

using Json = nlohmann::ordered_json;
using test::carom;
using test::Folder;
using testing::HasSubstr;

/// Three disks of radius 1, their centres 6 apart, and a point.
std::string pinball(const std::string& position, const std::string& velocity) {
  return R"(
[[ball]]
position = [-3, 0]
radius = 1
fixed = true
[[ball]]
position = [3, 0]
radius = 1
fixed = true
[[ball]]
position = [0, 5.196152422706632]
radius = 1
fixed = true
[run]
until = 100
[[ball]]
radius = 0
position = )" + position + "\nvelocity = " + velocity + "\n";
}

Json orbit(const std::string& scene, const std::string& period, const std::string& precision = "double") {
  const Folder folder;
  folder.write("a.toml", scene);
  const test::Outcome o = carom(folder, {"orbit", "a.toml", "--period", period, "--precision", precision, "--json"});
  EXPECT_EQ(o.status, 0) << o.err;
  return o.status == 0 ? Json::parse(o.out) : Json();
}

double multiplier(const Json& j) { return j["multipliers"][0]["real"]; }

// Between two disks: per bounce R/a - 1 + (R/a) sqrt(1 - 2a/R) = 5 + 2 sqrt 6; the cycle of two has length 2 (R - 2a).
TEST(Orbit, between_two_disks) {
  const Json j = orbit(pinball("[0.5, 0.001]", "[1, -0.0005]"), "2");
  EXPECT_NEAR(j["length"].get<double>(), 8.0, 1e-12);
  EXPECT_NEAR(multiplier(j), 49 + 20 * std::sqrt(6.0), 1e-12 * 98);
  EXPECT_NEAR(j["multipliers"][1]["real"].get<double>() * multiplier(j), 1.0, 1e-12);
  EXPECT_EQ(j["kind"], "hyperbolic");
  EXPECT_EQ(j["prime_collisions"], 2);
  EXPECT_LT(j["residual"].get<double>(), 1e-15);
  EXPECT_THAT(j["points"][0]["partner"], testing::AnyOf("ball 0", "ball 1"));
}

// Cycles of the three-disk system, lengths and multipliers of the symmetry-reduced domain [ChaosBook]: "1" has three
// copies in the triangle 0 1 2, "01" two in 0 1 0 2.
TEST(Orbit, cycles_of_the_pinball) {
  const Json one = orbit(pinball("[0.01, 0.5001]", "[1, 0.0001]"), "3");
  EXPECT_NEAR(one["length"].get<double>() / 3, 4.267949192431, 1e-12);
  EXPECT_NEAR(std::cbrt(multiplier(one)), -11.771455196386, 1e-11);
  const Json both = orbit(pinball("[0.433, 0.25]", "[-5.134, 0.5]"), "4");
  EXPECT_NEAR(both["length"].get<double>() / 2, 8.316529485168, 1e-12);
  EXPECT_NEAR(std::sqrt(multiplier(both)), 124.094801992, 1e-9);
}

// The length of an orbit does not depend on the speed.
TEST(Orbit, keeps_the_speed_of_its_start) {
  const Json j = orbit(pinball("[0.01, 0.5001]", "[3, 0.0003]"), "3");
  const auto v = j["start"][0]["velocity"].get<std::vector<double>>();
  EXPECT_NEAR(std::hypot(v[0], v[1]), std::hypot(3, 0.0003), 1e-14);
  EXPECT_NEAR(j["period"].get<double>() * std::hypot(3, 0.0003), j["length"].get<double>(), 1e-13);
  EXPECT_NEAR(j["length"].get<double>() / 3, 4.267949192431, 1e-12);
}

TEST(Orbit, has_the_digits_asked_for) {
  const Json j = orbit(pinball("[0.5, 0.001]", "[1, -0.0005]"), "2", "50");
  const std::string root = "97.989794855663561963945681494117827839318949613133402568653851345";  // 49 + 20 sqrt 6
  const std::string found = j["multipliers"][0]["real"];
  EXPECT_EQ(found.substr(0, 47), root.substr(0, 47));
  EXPECT_EQ(j["length"].get<std::string>().substr(0, 1), "8");
  EXPECT_LT(j["residual"].get<double>(), 1e-50);
}

// Twice around is an orbit of twice the collisions.
TEST(Orbit, tells_when_it_goes_around_more_than_once) {
  const Json j = orbit(pinball("[0.5, 0.0001]", "[1, -0.00005]"), "4");
  EXPECT_EQ(j["collisions"], 4);
  EXPECT_EQ(j["prime_collisions"], 2);
  EXPECT_NEAR(j["length"].get<double>(), 16.0, 1e-12);
}

const std::string triangle = R"([[wall]]
kind = "polygon"
vertices = [[0, 0], [1, 0], [0.5, 0.8660254037844386]]
[run]
events = 10
[[ball]]
radius = 0
)";

// Fagnano's orbit in an equilateral triangle of side 1: length 3/2. Three reflections turn what is beside it over, -1.
// Around twice, and its neighbours close after six hits: length 3, and the map is a shear.
TEST(Orbit, of_a_triangle_is_parabolic) {
  const Json j = orbit(triangle + "position = [0.5, 0.01]\nvelocity = [0.5, 0.87]\n", "3");
  EXPECT_NEAR(j["length"].get<double>(), 1.5, 1e-12);
  EXPECT_EQ(j["kind"], "parabolic");
  EXPECT_EQ(multiplier(j), -1.0);
  const Json twice = orbit(triangle + "position = [0.4, 0.01]\nvelocity = [0.5, 0.8663]\n", "6");
  EXPECT_NEAR(twice["length"].get<double>(), 3.0, 1e-12);
  EXPECT_EQ(twice["kind"], "parabolic");
  EXPECT_EQ(twice["prime_collisions"], 6);
}

// Across a circle of radius 1 through a point off its middle: the diameters are a family, so the start moves to one of them.
TEST(Orbit, is_found_in_a_family) {
  const Json j = orbit("[[wall]]\nkind = \"circle\"\ncentre = [0, 0]\nradius = 1\n[run]\nevents = 9\n[[ball]]\nradius = 0\n"
                       "position = [0.1, 0.02]\nvelocity = [1, 0.01]\n", "2");
  EXPECT_NEAR(j["length"].get<double>(), 4.0, 1e-12);
  EXPECT_EQ(j["kind"], "parabolic");
}

// Disks of radius 0.35 at whole numbers: between two rows, from the top of one to the bottom of the next but one, and on.
TEST(Orbit, closes_up_to_a_lattice_vector) {
  const Json j = orbit(R"([space]
kind = "periodic"
lower = [0, 0]
upper = [1, 1]
[run]
events = 5
[[ball]]
position = [0.5, 0.5]
radius = 0.35
fixed = true
[[ball]]
radius = 0
position = [0.00001, 0.0]
velocity = [1, 0.3]
)", "2");
  EXPECT_NEAR(j["length"].get<double>(), 2 * std::hypot(1, 0.3), 1e-12);
  EXPECT_EQ(j["start"][0]["shift"], Json({2, 0}));
  EXPECT_EQ(j["kind"], "hyperbolic");
}

// A ball that falls on a floor at speed v = sqrt(2 g h) is back after 2 v / g.
TEST(Orbit, under_gravity) {
  const Json j = orbit("dimension = 1\n[motion]\nacceleration = [-1]\n[[wall]]\nkind = \"plane\"\npoint = [0]\nnormal = [1]\n"
                       "[run]\nevents = 5\n[[ball]]\nradius = 0\nposition = [2]\n", "1");
  EXPECT_NEAR(j["period"].get<double>(), 4.0, 1e-14);
  EXPECT_TRUE(j["length"].is_null());
}

// Two equal disks that meet head-on in the middle of a box and go to its walls and back: four unknowns a ball.
TEST(Orbit, of_two_balls) {
  const Json j = orbit(test::head_on(2), "3");
  EXPECT_NEAR(j["period"].get<double>(), 8.0, 1e-12) << "each has 4 to go to its wall, and back";
  EXPECT_NEAR(j["length"].get<double>(), 16.0, 1e-12);
  EXPECT_EQ(j["multipliers"].size(), 6U);
}

TEST(Orbit, put_into_the_scene_goes_round) {
  const Folder folder;
  folder.write("a.toml", pinball("[0.01, 0.5001]", "[1, 0.0001]"));
  const Json j = Json::parse(carom(folder, {"orbit", "a.toml", "--period", "3", "--json"}).out);
  std::vector<std::string> words{"run", "a.toml", "--events", "6", "--json"};
  for (const Json& set : j["set"]) {
    words.push_back("--set");
    words.push_back(set);
  }
  const Json run = Json::parse(carom(folder, words).out);
  EXPECT_EQ(run["stopped_by"], "events");
  EXPECT_NEAR(run["time"].get<double>(), j["period"].get<double>() + j["points"][2]["time"].get<double>(), 1e-9);
}

TEST(Orbit, refuses_what_cannot_come_back) {
  const Folder folder;
  folder.write("a.toml", test::head_on(2));
  const test::Outcome lossy = carom(folder, {"orbit", "a.toml", "--period", "3", "--set", "collision.restitution=0.5"});
  EXPECT_EQ(lossy.status, 2);
  EXPECT_THAT(lossy.err, HasSubstr("dissipates"));
  EXPECT_EQ(carom(folder, {"orbit", "a.toml", "--period", "0"}).status, 2);
  EXPECT_EQ(carom(folder, {"orbit", "a.toml"}).status, 2) << "--period is required";

  folder.write("b.toml", pinball("[0.5, 0.1]", "[1, 0.3]"));
  const test::Outcome away = carom(folder, {"orbit", "b.toml", "--period", "4"});
  EXPECT_EQ(away.status, 3);
  EXPECT_EQ(away.out, "");
  EXPECT_THAT(away.err, HasSubstr("Begin nearer"));
}

}  // namespace
}  // namespace carom
