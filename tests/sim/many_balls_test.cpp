// Many balls: neighbour lists and the calendar, with vector instructions and without, give the log of the plain integrator,
// bit for bit, and full audits on the way find no overlap. (Energy and pressure do not notice a missed collision.)

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ostream>
#include <string>
#include <tuple>
#include <vector>

#include "carom/core/error.hpp"
#include "carom/scene/read.hpp"
#include "carom/sim/simulation.hpp"

namespace carom {
namespace {

using Line = std::tuple<std::int64_t, double, int, std::uint32_t, std::uint32_t, std::array<double, 3>, std::array<double, 3>,
                        std::array<double, 3>, std::array<std::int64_t, 3>, std::array<double, 3>, std::array<double, 3>,
                        std::array<std::int64_t, 3>, double, double, std::array<double, 3>, std::array<double, 3>>;

Line line_of(const Collision& c) {
  return {c.epoch,
          c.offset,
          int(c.kind),
          c.ball.number,
          c.partner.number,
          c.ball.position,
          c.ball.velocity_before,
          c.ball.velocity_after,
          c.ball.image,
          c.partner.position,
          c.partner.velocity_after,
          c.partner.image,
          c.impulse,
          c.gap,
          c.normal,
          c.point};
}

struct Named {
  const char* name;
  std::int64_t collisions;
  const char* text;

  friend void PrintTo(const Named& scene, std::ostream* out) { *out << scene.name; }
};

// At low and high density, in the plane and in space, closed and periodic; mixtures; dissipation; a lattice whose balls meet
// at equal times; periods hardly wider than the shells; balls much faster and much larger than others, up to twenty times
// and of many sizes; fixed ones; walls inside of a box, and tables without one.
const Named scenes[] = {
    {"disks", 6400, "dimension=2\n[[gas]]\ncount=400\npacking_fraction=0.3\nradius=0.5\n"},
    {"dense_disks", 12800, "dimension=2\n[[gas]]\ncount=400\npacking_fraction=0.69\nradius=0.5\n"},
    {"dilute_disks", 3200, "dimension=2\n[[gas]]\ncount=300\npacking_fraction=0.01\nradius=0.5\n"},
    {"spheres", 8000, "dimension=3\n[[gas]]\ncount=500\npacking_fraction=0.3\nradius=0.5\n"},
    {"dense_spheres", 16400, "dimension=3\n[[gas]]\ncount=500\npacking_fraction=0.49\nradius=0.5\n"},
    {"dilute_spheres", 3200, "dimension=3\n[[gas]]\ncount=400\npacking_fraction=0.005\nradius=0.5\n"},
    {"box_of_disks", 8000,
     "dimension=2\n[space]\nkind='box'\nlower=[-3,2]\nupper=[27,22]\n[[gas]]\ncount=300\npacking_fraction=0.4\n"},
    {"box_of_spheres", 8000,
     "dimension=3\n[space]\nkind='box'\nlower=[-1,0,0]\nupper=[8,9,10]\n[[gas]]\ncount=400\npacking_fraction=0.35\n"},
    {"mixture", 8000,
     "dimension=3\n[space]\nkind='periodic'\nlower=[0,0,0]\nupper=[10,11,12]\n[[gas]]\ncount=150\nradius=0.5\nmass=3\n"
     "[[gas]]\ncount=600\nradius=0.2\nmass=0.7\n"},
    {"ten_to_one", 6400,
     "dimension=2\n[space]\nkind='periodic'\nlower=[0,0]\nupper=[30,30]\n[[gas]]\ncount=4\nradius=2\nmass=400\n"
     "[[gas]]\ncount=500\nradius=0.2\nmass=1\n"},
    {"one_to_twenty", 8000,
     "dimension=2\n[space]\nkind='periodic'\nlower=[0,0]\nupper=[20,21]\n[[gas]]\ncount=3\nradius=4\nmass=400\n"
     "[[gas]]\ncount=900\nradius=0.2\nmass=1\n"},
    {"one_to_twenty_spheres", 2000,
     "dimension=3\n[space]\nkind='box'\nlower=[0,0,0]\nupper=[9,9,10]\n[[gas]]\ncount=1\nradius=4\nmass=8000\n"
     "[[gas]]\ncount=1600\nradius=0.2\nmass=1\n"},
    {"power_law", 4000, "power law"},
    {"granular", 8000,
     "dimension=2\n[collision]\nrestitution=0.9\n[space]\nkind='periodic'\nlower=[0,0]\nupper=[30,30]\n[[gas]]\ncount=300\n"
     "packing_fraction=0.3\n"},
    {"viscoelastic", 6400,
     "dimension=3\n[collision]\nrestitution=0.8\nregularise='viscoelastic'\nreference_speed=1\n[[gas]]\ncount=300\npacking_"
     "fraction=0.2\n"
     "radius=0.5\n"},
    {"contact_time", 6400,
     "dimension=2\n[collision]\nrestitution=0.7\ncontact_time=1e-4\n[space]\nkind='box'\nlower=[0,0]\nupper=[20,20]\n[[gas]"
     "]\n"
     "count=250\npacking_fraction=0.4\n"},
    {"obstacles", 6400,
     "dimension=2\n[space]\nkind='periodic'\nlower=[0,0]\nupper=[30,30]\n[[ball]]\nposition=[7,7]\nradius=1.5\nfixed=true\n"
     "[[ball]]\nposition=[20,17]\nradius=1\nmass='inf'\nvelocity=[0.1,0]\n[[gas]]\ncount=250\nradius=0.5\n"},
    {"one_fast_ball", 6400,
     "dimension=2\n[space]\nkind='periodic'\nlower=[0,0]\nupper=[30,30]\n[[ball]]\nposition=[7,7]\nradius=0.3\nmass=1e-9\n"
     "velocity=[1e4,2e3]\n[[gas]]\ncount=250\nradius=0.5\n"},
    {"narrow", 12800,
     "dimension=2\n[space]\nkind='periodic'\nlower=[0,0]\nupper=[3.06,49]\n[[gas]]\ncount=400\nradius=0.01\n"},
    {"narrow_mixture", 12800,
     "dimension=2\n[space]\nkind='periodic'\nlower=[0,0]\nupper=[2.2,68]\n[[gas]]\ncount=390\nradius=0.01\n[[gas]]\ncount="
     "10\n"
     "radius=0.05\n"},
    {"narrow_in_space", 6400,
     "dimension=3\n[space]\nkind='periodic'\nlower=[0,0,0]\nupper=[3,3.1,30]\n[[gas]]\ncount=300\nradius=0.02\n"},
    {"equal_times", 4000, "rows"},
    {"neighbours_hit_at_one_moment", 4000, "groups"},
    {"walls_in_a_box", 6400,
     "dimension=2\n[space]\nkind='box'\nlower=[0,0]\nupper=[24,20]\n[[wall]]\nkind='segment'\nfrom=[10,3]\nto=[14,17]\n"
     "[[wall]]\nkind='circle'\ncentre=[5,5]\nradius=2\nside='outside'\n[[wall]]\nkind='plane'\npoint=[20,0]\nnormal=[-1,1]"
     "\n"
     "[[gas]]\ncount=300\nradius=0.3\n"},
    {"stadium", 6400, "dimension=2\n[[table]]\nkind='stadium'\nradius=6\nlength=10\n[[gas]]\ncount=200\nradius=0.3\n"},
    {"granular_in_a_hexagon", 6400,
     "dimension=2\n[collision]\nrestitution=0.9\n[[table]]\nkind='polygon'\nsides=6\nside=12\n[[gas]]\ncount=250\nradius=0."
     "3\n"},
    {"walls_in_space", 6400,
     "dimension=3\n[space]\nkind='box'\nlower=[0,0,0]\nupper=[10,11,12]\n[[wall]]\nkind='plane'\npoint=[0,0,3]\n"
     "normal=[0,1,2]\n[[wall]]\nkind='circle'\ncentre=[5,6,7]\nradius=1.5\nside='outside'\n[[gas]]\ncount=120\nradius=0.5\n"
     "mass=2\n[[gas]]\ncount=500\nradius=0.2\n"},
};

// Rows of disks that fly at each other, each row slower than the one below: many collisions at one moment.
std::string rows_of_disks() {
  std::string text = "dimension=2\n[space]\nkind='box'\nlower=[0,0]\nupper=[16,16]\n";
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x)
      text += "[[ball]]\nradius=0.25\nposition=[" + std::to_string(x) + ".5," + std::to_string(y) + ".5]\nvelocity=[" +
              std::to_string((x % 2 == 0 ? 1 : -1) * (1 + y / 4)) + ",0]\n";
  return text;
}

// Groups of four disks: 0 hits 1 at the moment at which 3 hits 2. 1 would meet 2 as that was before, and does not.
std::string groups_of_four() {
  std::string text = "dimension=2\n[space]\nkind='periodic'\nlower=[0,0]\nupper=[32,32]\n";
  const auto ball = [&text](double x, double y, const std::string& velocity) {
    text += "[[ball]]\nradius=0.25\nposition=[" + std::to_string(x) + "," + std::to_string(y) + "]\nvelocity=[" + velocity +
            "]\n";
  };
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      ball(4 * x + 0.5, 4 * y + 3.125, "1,0");
      ball(4 * x + 1.5, 4 * y + 3.125, "0,0");
      ball(4 * x + 2.25, 4 * y + 3, "0,0");
      ball(4 * x + 2.25, 4 * y + 0.5, "0,4");
    }
  return text;
}

// Disks of 24 radii from 0.2 to 4, as many of each as cover the same area, at area fraction 0.6.
std::string power_law() {
  std::string text = "dimension=2\n[space]\nkind='periodic'\nlower=[0,0]\nupper=[60,65]\n";
  for (int k = 23; k >= 0; --k) {
    const double radius = 0.2 * std::pow(20.0, k / 23.0), area = 3.141592653589793 * radius * radius;
    text += "[[gas]]\ncount=" + std::to_string(std::max(1, int(0.6 * 60 * 65 / 24 / area))) + "\nradius=" + std::to_string(radius) +
            "\nmass=" + std::to_string(area) + "\n";
  }
  return text;
}

std::string text_of(const Named& named) {
  const std::string text = named.text;
  if (text == "rows") return rows_of_disks();
  if (text == "groups") return groups_of_four();
  return text == "power law" ? power_law() : text;
}

Scene scene_of(const Named& named, const char* search, const char* queue, bool vectors = true) {
  return read_scene(text_of(named) + "[run]\nevents=1000000\n", "test",
                    {{"engine.search", '"' + std::string(search) + '"'},
                     {"engine.queue", '"' + std::string(queue) + '"'},
                     {"engine.vectors", vectors ? "true" : "false"}});
}

struct Followed {
  std::vector<Line> log;
  Summary summary;
  std::int64_t overlaps = 0;
};

Followed follow(Simulation simulation, std::int64_t collisions, int slices) {
  Followed run;
  for (int k = 0; k < slices; ++k) {
    simulation.advance(std::nullopt, collisions / slices, [&](const Collision& c) { run.log.push_back(line_of(c)); });
    run.overlaps += simulation.audit().overlaps;
  }
  run.summary = simulation.summary();
  return run;
}

class ManyBallsIn : public testing::TestWithParam<Named> {};

TEST_P(ManyBallsIn, give_the_log_of_the_plain_integrator) {
  const Named& named = GetParam();
  const Followed plain = follow(Simulation(scene_of(named, "cells", "heap")), named.collisions, 4);
  ASSERT_GT(plain.log.size(), 1000u);
  EXPECT_EQ(plain.overlaps, 0);
  for (const auto& [search, queue, vectors] : {std::tuple{"neighbour_list", "calendar", true},
                                               std::tuple{"neighbour_list", "calendar", false},
                                               std::tuple{"cells", "calendar", true}}) {
    const Followed other = follow(Simulation(scene_of(named, search, queue, vectors)), named.collisions, 16);
    EXPECT_EQ(other.overlaps, 0);
    EXPECT_EQ(other.summary.exactness.clamped, 0);
    ASSERT_EQ(other.log.size(), plain.log.size());
    for (std::size_t k = 0; k < plain.log.size(); ++k)
      ASSERT_EQ(other.log[k], plain.log[k]) << "collision " << k << ", " << search << ", " << queue;
    EXPECT_EQ(other.summary.energy.final.value, plain.summary.energy.final.value);
    EXPECT_EQ(other.summary.energy.dissipated.value, plain.summary.energy.dissipated.value);
    EXPECT_EQ(other.summary.exactness.max_gap_error.value, plain.summary.exactness.max_gap_error.value);
    EXPECT_EQ(other.summary.events.ties, plain.summary.events.ties);
  }
}

// A state is that of the run, whoever wrote it.
TEST_P(ManyBallsIn, go_on_from_each_others_states) {
  const Named& named = GetParam();
  const std::int64_t half = named.collisions / 2;
  Simulation cells(scene_of(named, "cells", "heap")), lists(scene_of(named, "neighbour_list", "calendar"));
  cells.advance(std::nullopt, half);
  lists.advance(std::nullopt, half);
  const std::string from_cells = cells.state(), from_lists = lists.state();
  Simulation other_cells(scene_of(named, "cells", "heap")), other_lists(scene_of(named, "neighbour_list", "calendar"));
  other_cells.restore(from_lists);
  other_lists.restore(from_cells);
  std::vector<Line> log, other, third;
  cells.advance(std::nullopt, half, [&](const Collision& c) { log.push_back(line_of(c)); });
  other_cells.advance(std::nullopt, half, [&](const Collision& c) { other.push_back(line_of(c)); });
  other_lists.advance(std::nullopt, half, [&](const Collision& c) { third.push_back(line_of(c)); });
  EXPECT_EQ(log, other);
  EXPECT_EQ(log, third);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ManyBallsIn, testing::ValuesIn(scenes),
                         [](const auto& named) { return std::string(named.param.name); });

TEST(ManyBallsChoice, is_made_from_the_scene) {
  const auto search = [](const std::string& text) {
    return Simulation(read_scene(text + "[run]\nevents=10\n", "test")).composition().search;
  };
  EXPECT_EQ(search("dimension=3\n[[gas]]\ncount=1000\npacking_fraction=0.3\nradius=0.5\n"), "neighbour lists");
  EXPECT_EQ(search("dimension=3\n[[gas]]\ncount=50\npacking_fraction=0.3\nradius=0.5\n"), "cells");
  EXPECT_EQ(search("dimension=2\n[motion]\nacceleration=[0,-1]\n[space]\nkind='box'\nlower=[0,0]\nupper=[40,40]\n[[gas]]\n"
                   "count=500\nradius=0.5\n"),
            "cells");
}

TEST(ManyBallsChoice, says_why_lists_do_not_fit) {
  const auto why = [](const std::string& text, const char* queue = "auto") -> std::string {
    try {
      Simulation simulation(read_scene("[[gas]]\ncount=50\nradius=0.5\n" + text + "[run]\nevents=1\n", "test",
                                       {{"engine.search", "\"neighbour_list\""}, {"engine.queue", '"' + std::string(queue) + '"'}}));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  const std::string box = "[space]\nkind='box'\nlower=[0,0]\nupper=[40,40]\n", period = "[space]\nkind='periodic'\nlower=[0,0]\n";
  EXPECT_THAT(why(box), testing::IsEmpty());
  EXPECT_THAT(why(box, "heap"), testing::HasSubstr("calendar as queue"));
  EXPECT_THAT(why(box + "[motion]\nacceleration=[0,-1]\n"), testing::HasSubstr("do not fly freely"));
  EXPECT_THAT(why(box + "[collision]\nlaw='stick'\n"), testing::HasSubstr("law = \"restitution\""));
  EXPECT_THAT(why(box + "[[wall]]\nkind='segment'\nfrom=[0,0]\nto=[9,9]\nvelocity=[1,0]\n"), testing::HasSubstr("a wall moves"));
  EXPECT_THAT(why(period + "upper=[40,40]\n[[wall]]\nkind='segment'\nfrom=[0,0]\nto=[9,9]\n"), testing::HasSubstr("periodic"));
  EXPECT_THAT(why(period + "upper=[40,2.5]\n"), testing::HasSubstr("a period is too short"));
}

// Rows are put in order again once in 1000 collisions a ball of the scene: nothing of the motion changes by that. Collisions go
// apart as chaos does, so that the last hundred tell of all before.
TEST(ManyBalls, fly_on_when_their_rows_are_sorted) {
  const Named gas{"gas", 0, "dimension=2\n[[gas]]\ncount=50\npacking_fraction=0.4\nradius=0.5\n"};
  std::vector<Line> logs[2];
  for (const bool lists : {false, true}) {
    Simulation simulation(lists ? scene_of(gas, "neighbour_list", "calendar") : scene_of(gas, "cells", "heap"));
    EXPECT_EQ(simulation.composition().search, lists ? "neighbour lists" : "cells");
    simulation.advance(std::nullopt, 149'900);
    EXPECT_EQ(simulation.audit().overlaps, 0);
    simulation.advance(std::nullopt, 100, [&](const Collision& c) { logs[lists ? 1 : 0].push_back(line_of(c)); });
  }
  EXPECT_EQ(logs[0].size(), 100u);
  EXPECT_EQ(logs[0], logs[1]);
}

// The way back in time: what was undone is where it began, to what rounding makes of few collisions.
TEST(ManyBalls, fly_back) {
  Simulation simulation(read_scene("dimension=3\n[[gas]]\ncount=500\npacking_fraction=0.1\nradius=0.5\n[run]\nevents=1000000\n",
                                   "test"));
  ASSERT_EQ(simulation.composition().search, "neighbour lists");
  const BallState before = simulation.ball(7);
  simulation.advance(std::nullopt, 60);
  const Number t = simulation.time();
  simulation.reverse();
  simulation.advance(Number(2 * t.value), std::nullopt);
  const BallState after = simulation.ball(7);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(after.unwrapped_position[k].value, before.unwrapped_position[k].value, 1e-9);
}

}  // namespace
}  // namespace carom
