// Balls that grow: every search and queue gives the same log, bit for bit, a state goes on bit for bit under another
// engine, and full audits with the radii of the moment find no overlap on the way.

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "carom/core/error.hpp"
#include "carom/scene/read.hpp"
#include "sim/scenes.hpp"

namespace carom {
namespace {

using testing::difference;

struct Named {
  const char* name;
  const char* text;

  friend void PrintTo(const Named& scene, std::ostream* out) { *out << scene.name; }
};

// On a line, in the plane and in space, closed, periodic and open; from points; two rates; balls that do not grow among
// those that do; every wall; dissipation; velocities scaled back on the way.
const Named scenes[] = {
    {"rods",
     "dimension=1\n[space]\nkind='periodic'\nlower=[0]\nupper=[30]\n[[gas]]\ncount=20\npacking_fraction=0.3\nradius_growth="
     "0.01\n"},
    {"disks",
     "dimension=2\n[[gas]]\ncount=60\npacking_fraction=0.3\nradius=0.5\nradius_growth=0.02\n[run]\nrescale_every=300\n"},
    {"disks_in_a_box",
     "dimension=2\n[space]\nkind='box'\nlower=[-3,2]\nupper=[9,12]\n[[gas]]\ncount=60\npacking_fraction=0.4\nradius_growth="
     "0.01\n"},
    {"spheres", "dimension=3\n[[gas]]\ncount=80\npacking_fraction=0.2\nradius=0.5\nradius_growth=0.05\n"},
    {"from_points",
     "dimension=3\n[space]\nkind='periodic'\nlower=[0,0,0]\nupper=[1,1,1]\n[[gas]]\ncount=50\nradius=0\nradius_growth=0."
     "02\n"},
    {"points_at_rest_in_a_box",
     "dimension=2\n[space]\nkind='box'\nlower=[0,0]\nupper=[1,1]\n[[gas]]\ncount=30\nradius=0\ntemperature=0\nradius_"
     "growth=0.02\n"},
    {"mixture",
     "dimension=2\n[space]\nkind='periodic'\nlower=[0,0]\nupper=[20,20]\n[[gas]]\ncount=40\nradius=0.7\nradius_growth=0."
     "014\nmass=2\n"
     "[[gas]]\ncount=60\nradius=0.5\nradius_growth=0.01\n[[gas]]\ncount=20\nradius=0.4\n[[ball]]\nposition=[3,3]\nfixed="
     "true\n"},
    {"open",
     "dimension=2\n[[ball]]\nposition=[0,0]\nvelocity=[0.4,0.1]\nradius_growth=0.02\n[[ball]]\nposition=[3,0]\nradius_"
     "growth=0.05\n"
     "[[ball]]\nposition=[1,4]\nvelocity=[0,-0.3]\n[[ball]]\nposition=[-2,-3]\nradius_growth=0.03\n"},
    {"every_wall",
     "dimension=2\n[space]\nkind='box'\nlower=[0,0]\nupper=[12,12]\n[[gas]]\ncount=25\nradius=0.3\nradius_growth=0.004\n[["
     "ball]]\n"
     "position=[1,11]\nvelocity=[1,-0.7]\nradius=0.1\n[[wall]]\nkind='segment'\nfrom=[2,2]\nto=[4,7]\n[[wall]]\nkind='"
     "polygon'\n"
     "vertices=[[7,7],[9,7.5],[8,9]]\n[[wall]]\nkind='circle'\ncentre=[9,3]\nradius=1\nside='outside'\n[[wall]]\nkind='"
     "plane'\n"
     "point=[0,-1]\nnormal=[0.2,1]\nrestitution=0.9\n"},
    {"in_a_sphere",
     "dimension=3\n[space]\nkind='box'\nlower=[-5,-5,-5]\nupper=[5,5,5]\n[[wall]]\nkind='circle'\ncentre=[0,0,0]\nradius="
     "5\n"
     "[[gas]]\ncount=30\nradius=0.4\nradius_growth=0.01\n"},
    {"granular",
     "dimension=2\n[collision]\nrestitution=0.9\n[space]\nkind='periodic'\nlower=[0,0]\nupper=[12,12]\n[[gas]]\ncount=50\n"
     "packing_fraction=0.3\nradius_growth=0.02\n"},
};

struct Followed {
  std::vector<Collision> log;
  Summary summary;
  std::int64_t overlaps = 0;
};

Followed follow(Simulation simulation, int slices, std::int64_t per_slice) {
  Followed run;
  for (int k = 0; k < slices; ++k) {
    simulation.advance(std::nullopt, per_slice, [&](const Collision& c) { run.log.push_back(c); });
    run.overlaps += simulation.audit(AuditBy::every_pair).overlaps;
  }
  run.summary = simulation.summary();
  return run;
}

class EveryGrowing : public ::testing::TestWithParam<Named> {
 protected:
  static Scene scene(const char* search, const char* queue = "heap") {
    return read_scene(GetParam().text, "test",
                      {{"engine.search", '"' + std::string(search) + '"'},
                       {"engine.queue", '"' + std::string(queue) + '"'},
                       {"run.events", "2000"}});
  }
};

TEST_P(EveryGrowing, gives_the_same_log_and_no_overlap) {
  const Followed pairs = follow(Simulation(scene("all_pairs")), 40, 50);
  ASSERT_GE(pairs.log.size(), 2u);
  EXPECT_EQ(pairs.overlaps, 0);
  EXPECT_EQ(pairs.summary.exactness.clamped, 0);
  for (const Followed& other :
       {follow(Simulation(scene("cells")), 40, 50), follow(Simulation(scene("cells", "calendar")), 8, 250),
        follow(Simulation::reference(scene("auto")), 8, 250)}) {
    EXPECT_EQ(difference(pairs.log, other.log), "");
    EXPECT_EQ(other.overlaps, 0);
    EXPECT_EQ(other.summary.exactness.clamped, 0);
  }
  EXPECT_LE(pairs.summary.energy.relative_error, 1e-13);
  EXPECT_LE(pairs.summary.exactness.max_gap_error_relative, 1e-13);
}

TEST_P(EveryGrowing, goes_on_from_its_state_bit_for_bit) {
  std::vector<Collision> whole, rest;
  Simulation once(scene("auto"));
  once.advance(std::nullopt, 430);
  const std::string state = once.state();
  once.advance(std::nullopt, 900, [&](const Collision& c) { whole.push_back(c); });
  Simulation again = Simulation::reference(scene("auto"));  // another queue and search
  again.restore(state);
  again.advance(std::nullopt, 900, [&](const Collision& c) { rest.push_back(c); });
  EXPECT_EQ(difference(whole, rest), "");
  const Summary a = once.summary(), b = again.summary();
  EXPECT_EQ(a.growth->reduced_pressure, b.growth->reduced_pressure);
  EXPECT_EQ(a.energy.injected, b.energy.injected);
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryGrowing, ::testing::ValuesIn(scenes),
                         [](const ::testing::TestParamInfo<Named>& one) { return std::string(one.param.name); });

// A state knows at which rates it grew.
TEST(GrowingState, of_another_rate_is_refused) {
  const auto scene = [](const char* rate) {
    return read_scene("dimension=2\n[[gas]]\ncount=20\npacking_fraction=0.3\nradius=0.5\n[run]\nevents=50\n", "test",
                      {{"gas.0.radius_growth", rate}});
  };
  Simulation a(scene("0.01"));
  a.run();
  EXPECT_THROW(Simulation(scene("0.02")).restore(a.state()), InputError);
  EXPECT_THROW(Simulation(scene("0")).restore(a.state()), InputError);
}

// Looking and stopping in between change nothing.
TEST(GrowingRun, is_the_same_in_small_steps_of_time) {
  const Scene scene = read_scene(
      "dimension=2\n[[gas]]\ncount=40\npacking_fraction=0.2\nradius=0.5\nradius_growth=0.03\n"
      "[run]\nuntil=5\nrescale_every=100\n",
      "test");
  const auto end = [&](double step) {
    Simulation simulation(scene);
    for (double t = step; t < 5; t += step) simulation.advance(Number(t));
    simulation.advance(Number(5.0));
    return simulation.state();
  };
  EXPECT_EQ(end(5.0), end(0.01));
}

}  // namespace
}  // namespace carom
