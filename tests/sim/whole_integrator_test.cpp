// One scene, many engines: every search and queue gives the same log, bit for bit, and a full audit finds no overlap on the
// way. Then the state of a run as bytes, the way back in time, and the laws that join balls.

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <string>
#include <tuple>
#include <vector>

#include "carom/core/error.hpp"
#include "carom/scene/read.hpp"
#include "carom/sim/simulation.hpp"

namespace carom {
namespace {

using Line =
    std::tuple<std::int64_t, double, int, std::uint32_t, std::uint32_t, int, std::array<double, 3>, std::array<double, 3>,
               std::array<std::int64_t, 3>, std::array<double, 3>, std::array<double, 3>, double, bool>;

Line line_of(const Collision& c) {
  return {c.epoch,
          c.offset,
          int(c.kind),
          c.ball.number,
          c.partner.number,
          c.feature,
          c.ball.position,
          c.ball.velocity_after,
          c.ball.image,
          c.partner.position,
          c.partner.velocity_after,
          c.impulse,
          c.tie};
}

struct Named {
  const char* name;
  const char* text;

  friend void PrintTo(const Named& scene, std::ostream* out) { *out << scene.name; }
};

// Small cells, long corridors, fixed partners, radii that differ twentyfold, gravity, every wall, dissipation.
const Named scenes[] = {
    {"disks_in_a_box",
     "dimension=2\n[space]\nkind='box'\nlower=[0,0]\nupper=[14,14]\n[[gas]]\ncount=60\npacking_fraction=0.4\n"},
    {"dense_disks",
     "dimension=2\n[space]\nkind='periodic'\nlower=[0,0]\nupper=[10,10]\n[[gas]]\ncount=80\npacking_fraction=0.68\n"},
    {"spheres", "dimension=3\n[[gas]]\ncount=64\npacking_fraction=0.3\nradius=0.5\n"},
    {"dense_spheres", "dimension=3\n[[gas]]\ncount=64\npacking_fraction=0.49\nradius=0.5\n"},
    {"spheres_in_open_space",
     "dimension=3\n[space]\nkind='open'\n[[ball]]\nposition=[0,0,0]\nvelocity=[1,0,0]\n[[ball]]\nposition=[3,0.2,0.1]\n"
     "[[ball]]\nposition=[5,-0.3,0.2]\nvelocity=[-1,0,0]\n[[ball]]\nposition=[4,2,0.2]\nvelocity=[0,-1,0]\n"},
    {"twenty_to_one",
     "dimension=2\n[space]\nkind='periodic'\nlower=[0,0]\nupper=[20,20]\n[[gas]]\ncount=4\nradius=2\nmass=400\n"
     "[[gas]]\ncount=100\nradius=0.1\nmass=1\n"},
    {"rods", "dimension=1\n[space]\nkind='periodic'\nlower=[0]\nupper=[30]\n[[gas]]\ncount=20\npacking_fraction=0.5\n"},
    {"corridor",
     "dimension=2\n[space]\nkind='periodic'\nlower=[0,0]\nupper=[40,1.3]\n[[ball]]\nposition=[1,0.2]\nvelocity=[1,0.37]"
     "\nradius=0.3\n"
     "[[ball]]\nposition=[5,0.5]\nvelocity=[-0.2,0.51]\nradius=0.3\n[[ball]]\nposition=[9,0.9]\nvelocity=[0.4,-0.11]"
     "\nradius=0.3\n"
     "[[ball]]\nposition=[19,0.9]\nfixed=true\nradius=0.3\n"},
    {"lorentz_with_reach_beyond_the_cell",  // sigma 0.8 in a cell of 1 x 3: a fixed partner several images away
     "dimension=2\n[space]\nkind='periodic'\nlower=[0,0]\nupper=[1,3]\n[[ball]]\nposition=[0.5,0.3]\nradius=0.8\nfixed="
     "true\n"
     "[[ball]]\nposition=[0.1,1.7]\nvelocity=[0.8,0.6]\nradius=0.05\n"},
    {"gravity_in_a_box",
     "dimension=2\n[motion]\nacceleration=[0.1,-1]\n[space]\nkind='box'\nlower=[0,0]\nupper=[9,12]\n[[gas]]\ncount="
     "40\nradius=0.3\n"
     "[[ball]]\nposition=[4,3]\nradius=1\nfixed=true\n"},
    {"gravity_periodic",
     "dimension=3\n[motion]\nacceleration=[0,0,-0.5]\n[[gas]]\ncount=40\npacking_fraction=0.2\nradius=0.5\n"},
    {"every_wall",
     "dimension=2\n[space]\nkind='box'\nlower=[0,0]\nupper=[12,12]\n[[gas]]\ncount=25\nradius=0.3\n[[ball]]\nposition=[1,"
     "11]\nvelocity=[1,-0.7]\n"
     "radius=0\n[[wall]]\nkind='segment'\nfrom=[2,2]\nto=[4,7]\n[[wall]]\nkind='polygon'\nvertices=[[7,7],[9,7.5],[8,9]]\n"
     "[[wall]]\nkind='circle'\ncentre=[9,3]\nradius=1\nside='outside'\n[[wall]]\nkind='plane'\npoint=[0,-1]\nnormal=[0.2,1]"
     "\n"
     "restitution=0.999\n"},
    {"granular",
     "dimension=2\n[collision]\nrestitution=0.95\n[space]\nkind='periodic'\nlower=[0,0]\nupper=[12,12]\n[[gas]]\ncount=50\n"
     "packing_fraction=0.3\n"},
    {"moving_walls",
     "dimension=2\n[space]\nkind='box'\nlower=[0,0]\nupper=[20,10]\n[[gas]]\ncount=30\nradius=0.2\n[[wall]]\nkind='plane'"
     "\npoint=[19.9,0]\n"
     "normal=[-1,0]\nvelocity=[-0.01,0]\n"},
};

struct Followed {
  std::vector<Line> log;
  Summary summary;
  std::int64_t overlaps = 0;
};

Followed follow(Simulation simulation, int slices, std::int64_t per_slice) {
  Followed run;
  for (int k = 0; k < slices; ++k) {
    simulation.advance(std::nullopt, per_slice, [&](const Collision& c) { run.log.push_back(line_of(c)); });
    run.overlaps += simulation.audit(AuditBy::every_pair).overlaps;
  }
  run.summary = simulation.summary();
  return run;
}

class EveryEngine : public testing::TestWithParam<Named> {};

TEST_P(EveryEngine, gives_the_same_log_and_no_overlap) {
  const auto scene = [&](const char* search) {
    return read_scene(std::string(GetParam().text) + "[run]\nevents=3000\n", "test",
                      {{"engine.search", '"' + std::string(search) + '"'}});
  };
  const Followed pairs = follow(Simulation(scene("all_pairs")), 60, 50);
  ASSERT_GE(pairs.log.size(), 2u);
  EXPECT_EQ(pairs.overlaps, 0);
  for (const Followed& other :
       {follow(Simulation(scene("cells")), 60, 50), follow(Simulation::reference(scene("auto")), 7, 430)}) {
    EXPECT_EQ(other.overlaps, 0);
    EXPECT_EQ(other.summary.exactness.clamped, 0);
    const std::size_t n = std::min(pairs.log.size(), other.log.size());
    ASSERT_GE(n + 1, pairs.log.size() < 3000 ? pairs.log.size() : std::size_t{3000});
    for (std::size_t k = 0; k < n; ++k) ASSERT_EQ(pairs.log[k], other.log[k]) << "collision " << k;
  }
  EXPECT_LE(pairs.summary.energy.relative_error, 1e-13);
}

TEST_P(EveryEngine, goes_on_from_its_state_bit_for_bit) {
  const Scene scene = read_scene(std::string(GetParam().text) + "[run]\nevents=600\n", "test");
  std::vector<Line> whole, rest;
  Simulation once(scene);
  once.advance(std::nullopt, 250);
  const std::string state = once.state();
  once.advance(std::nullopt, 350, [&](const Collision& c) { whole.push_back(line_of(c)); });
  Simulation again = Simulation::reference(scene);  // another queue and search
  again.restore(state);
  again.advance(std::nullopt, 350, [&](const Collision& c) { rest.push_back(line_of(c)); });
  EXPECT_EQ(whole, rest);
  EXPECT_EQ(once.state().size(), again.state().size());
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryEngine, testing::ValuesIn(scenes),
                         [](const testing::TestParamInfo<Named>& one) { return std::string(one.param.name); });

TEST(State, damaged_or_foreign_is_refused_and_changes_nothing) {
  const Scene scene = read_scene(std::string(scenes[0].text) + "[run]\nevents=100\n", "test");
  Simulation a(scene);
  a.run();
  const std::string state = a.state();
  Simulation b(scene);
  for (const std::size_t at : {std::size_t{0}, std::size_t{9}, std::size_t{20}, state.size() / 2, state.size() - 1}) {
    std::string damaged = state;
    damaged[at] = static_cast<char>(damaged[at] ^ 4);
    EXPECT_THROW(b.restore(damaged), InputError) << at;
  }
  for (const std::size_t length : {std::size_t{0}, std::size_t{10}, state.size() - 1})
    EXPECT_THROW(b.restore(state.substr(0, length)), InputError);
  EXPECT_THROW(Simulation(read_scene(std::string(scenes[1].text) + "[run]\nevents=1\n", "test")).restore(state),
               InputError);
  EXPECT_EQ(b.counts().collisions(), 0);
  b.restore(state);
  EXPECT_EQ(b.state(), state);
}

// A ball that flies back along its path meets its impacts in reverse.
TEST(Reverse, leads_back_to_the_start) {
  const Scene scene = read_scene(
      "dimension=2\n[motion]\nacceleration=[0,-1]\n[[ball]]\nposition=[0.5,2]\nvelocity=[0.3,0]\nradius=0.1\n"
      "[[wall]]\nkind='polygon'\nvertices=[[-1,0],[3,0],[3,4],[-1,4]]\n[run]\nuntil=100\n",
      "test");
  Simulation simulation(scene);
  simulation.run();
  const std::int64_t there = simulation.counts().collisions();
  ASSERT_GT(there, 20);
  simulation.reverse();
  simulation.advance(Number(200.0));
  EXPECT_EQ(simulation.counts().collisions(), 2 * there);
  const BallState ball = simulation.ball(0);
  EXPECT_NEAR(ball.position[0], 0.5, 1e-12);
  EXPECT_NEAR(ball.position[1], 2.0, 1e-12);
}

// Energy of 1e5 bounces under gravity among segments: rounding walks, it does not drift; nothing gets out.
TEST(Gravity, keeps_its_energy_and_its_box) {
  for (const char* radius : {"0.1", "0"}) {
    Simulation simulation(
        read_scene("dimension=2\n[motion]\nacceleration=[0,-1]\n[[ball]]\nposition=[0.5,2]\nvelocity=[0.3,0]\nradius=" +
                       std::string(radius) +
                       "\n[[wall]]\nkind='segment'\nfrom=[-1,0]\nto=[3,0]\n[[wall]]\nkind='segment'\nfrom=[3,0]\nto=[3,4]\n"
                       "[[wall]]\nkind='segment'\nfrom=[3,4]\nto=[-1,4]\n[[wall]]\nkind='segment'\nfrom=[-1,4]\nto=[-1,0]\n"
                       "[run]\nevents=100000\n",
                   "test"));
    EXPECT_EQ(simulation.run(), Stop::events);
    EXPECT_LE(simulation.summary().energy.relative_error, 1e-13);
    const BallState ball = simulation.ball(0);
    EXPECT_GE(ball.position[0], -1);
    EXPECT_LE(ball.position[0], 3);
    EXPECT_GE(ball.position[1], -1e-15);
  }
}

// A point in a polygon with a reflex corner: 1e5 bounces inside, at three speeds, and the polygon turned.
TEST(Polygon, leaks_no_point) {
  for (const double turn : {0.0, 0.1, 0.7, 1.3}) {
    Scene scene;
    WallSpec wall;
    wall.kind = WallKind::polygon;
    const double corners[][2] = {{0, 0}, {2, 0.1}, {1.7, 1.9}, {1.0, 0.9}, {0.1, 1.5}};
    const double c = std::cos(turn), s = std::sin(turn);
    for (const auto& p : corners) wall.vertices.push_back({c * p[0] - s * p[1], s * p[0] + c * p[1]});
    scene.walls.push_back(wall);
    BallSpec ball;
    ball.radius = 0.0;
    ball.position = {c * 0.5 - s * 0.3, s * 0.5 + c * 0.3};
    ball.velocity = {0.3, 0.777};
    scene.balls.push_back(ball);
    scene.run.events = 100000;
    Simulation simulation(scene);
    EXPECT_EQ(simulation.run(), Stop::events) << turn;
    EXPECT_LE(simulation.summary().energy.relative_error, 1e-13);
  }
}

// The lecture's v = (m1 u1 + m2 u2) / (m1 + m2), and the loss mu |g|^2 / 2.
TEST(Stick, moves_on_with_the_common_velocity) {
  Simulation simulation(
      read_scene("dimension=3\n[collision]\nlaw='stick'\n[[ball]]\nposition=[0,0,0]\nvelocity=[5,0,1]\nmass=2\n"
                 "[[ball]]\nposition=[3,0.3,0.2]\nvelocity=[-1,0,0]\nmass=3\n[[ball]]\nposition=[9,0.3,0.3]\nvelocity=[-1,"
                 "0,0]\nmass=5\n[run]\nuntil=20\n",
                 "test"));
  simulation.run();
  EXPECT_EQ(simulation.counts().ball_ball, 2);
  const Summary s = simulation.summary();
  for (const BallState& b : simulation.balls()) {
    EXPECT_NEAR(b.velocity[0], (10.0 - 3.0 - 5.0) / 10.0, 1e-15);
    EXPECT_NEAR(b.velocity[2], 0.2, 1e-15);
  }
  EXPECT_NEAR(s.energy.dissipated, s.energy.initial - 0.5 * 10 * (0.04 + 0.04), 1e-13);
  EXPECT_LE(s.energy.relative_error, 1e-15);
  EXPECT_LE(*s.momentum.relative_error, 1e-15);
}

// Ballistic aggregation to the last ball: mass and momentum stay, the books balance.
TEST(Aggregation, balances_its_books) {
  for (const char* law : {"stick", "merge"})
    for (const char* dimension : {"2", "3"}) {
      const bool plane = dimension[0] == '2';
      Simulation simulation(read_scene(
          "dimension=" + std::string(dimension) + "\n[collision]\nlaw='" + law +
              "'\n[space]\nkind='periodic'\nlower=" + (plane ? "[0,0]\nupper=[20,20]" : "[0,0,0]\nupper=[9,9,9]") +
              "\n[[gas]]\ncount=80\nradius=0.3\n[run]\nuntil=3000\n",
          "test"));
      simulation.run();
      const Summary s = simulation.summary();
      EXPECT_GE(s.events.ball_ball, 70) << law << dimension;
      EXPECT_LE(s.energy.relative_error, 1e-14);
      EXPECT_LE(*s.momentum.relative_error, 1e-14);
      EXPECT_EQ(s.exactness.clamped, 0);
      double mass = 0;
      for (const BallState& b : simulation.balls()) mass += b.mass;
      EXPECT_NEAR(mass, 80, 1e-12);
      EXPECT_EQ(simulation.audit(AuditBy::every_pair).overlaps, 0);
    }
}

// T = sqrt(2 h / g) (1 + e) / (1 - e): the bounces accumulate there, and the run says so instead of hanging.
TEST(BouncingBall, stops_at_the_accumulation_point) {
  Simulation simulation(
      read_scene("dimension=1\n[motion]\nacceleration=[-9.81]\n[collision]\nrestitution=0.9\n[[ball]]\nposition=[1.5]\n[["
                 "wall]]\nkind='plane'\n"
                 "point=[0]\nnormal=[1]\n[run]\nuntil=20\n",
                 "test"));
  EXPECT_EQ(simulation.run(), Stop::collapse);
  EXPECT_NEAR(simulation.time(), 8.578949178729, 1e-10);
  EXPECT_EQ(simulation.summary().stopped->balls, std::vector<std::uint32_t>{0});
}

// Start exactly on a two-sided wall: the velocity says which side.
TEST(Segment, takes_the_side_that_the_velocity_points_to) {
  for (const double vy : {1.0, -1.0}) {
    Scene scene;
    WallSpec wall;
    wall.kind = WallKind::segment;
    wall.from = {-1.0, 0.0};
    wall.to = {1.0, 0.0};
    scene.walls.push_back(wall);
    BallSpec ball;
    ball.radius = 0.0;
    ball.position = {0.0, 0.0};
    ball.velocity = {0.0, vy};
    scene.balls.push_back(ball);
    scene.run.until = 5.0;
    Simulation simulation(scene);
    simulation.run();
    EXPECT_EQ(simulation.counts().collisions(), 0);
    EXPECT_EQ(simulation.ball(0).position[1], 5 * vy);
  }
}

}  // namespace
}  // namespace carom
