// Few balls: the table of meetings, with vector instructions and without, gives the events of the plain integrator, bit for
// bit, whether they are recorded or not. (Where nobody records them, impacts are computed another way.)

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "carom/scene/read.hpp"
#include "carom/sim/simulation.hpp"
#include "sim/scenes.hpp"

namespace carom {
namespace {

using namespace testing;

struct Named {
  const char* name;
  const char* text;

  friend void PrintTo(const Named& scene, std::ostream* out) { *out << scene.name; }
};

#define CAROM_UNIT_CELL "dimension=2\n[space]\nkind='periodic'\nlower=[-0.3,0.2]\nupper=[0.7,1.2]\n"
#define CAROM_POINT "[[ball]]\nposition=[-0.2,0.31]\nvelocity=[0.6,0.81]\nradius=0\n"

#define CAROM_POINT_AT(x) "[[ball]]\nposition=[" x "]\nvelocity=[0.6,0.81]\nradius=0\n"

// Box and periodic cells, points and balls, mixtures, circles from inside and outside, walls that the table does not know,
// tables that are repeated, long corridors, dissipation, obstacles, symmetric scenes that are full of ties, a path along an axis, contacts at the start.
const Named scenes[] = {
    {"five_disks",
     "dimension=2\n[space]\nkind='box'\nlower=[0,0]\nupper=[10,10]\n"
     "[[ball]]\nposition=[2,2]\nvelocity=[0.6,0.8]\nradius=0.5\n[[ball]]\nposition=[7.3,2.1]\nvelocity=[-0.3,0.5]\nradius=0.7\nmass=2\n"
     "[[ball]]\nposition=[5,5]\nvelocity=[-0.9,-0.2]\nradius=0.6\n[[ball]]\nposition=[2.2,7.7]\nvelocity=[0.1,0.7]\nradius=0.5\n"
     "[[ball]]\nposition=[8,8]\nvelocity=[0.3,-0.77]\nradius=0.8\nmass=3\n"},
    {"twelve_dense_disks", "dimension=2\n[space]\nkind='box'\nlower=[0,0]\nupper=[4.3,4.1]\n[[gas]]\ncount=12\nradius=0.5\n"},
    {"seven_spheres", "dimension=3\n[space]\nkind='box'\nlower=[-1,0,0]\nupper=[3,3,5]\n[[gas]]\ncount=7\nradius=0.6\nmass=0.3\n"},
    {"eight_disks_periodic",
     "dimension=2\n[space]\nkind='periodic'\nlower=[0,0]\nupper=[4,6]\n[[gas]]\ncount=5\nradius=0.6\n[[gas]]\ncount=3\nradius=0.3\nmass=0.2\n"},
    {"six_spheres_periodic", "dimension=3\n[space]\nkind='periodic'\nlower=[0,0,0]\nupper=[3,4,3.5]\n[[gas]]\ncount=6\nradius=0.7\n"},
    {"sinai", CAROM_UNIT_CELL CAROM_POINT "[[ball]]\nposition=[0.2,0.7]\nradius=0.35\nfixed=true\n"},
    {"sinai_of_disks",
     CAROM_UNIT_CELL "[[ball]]\nposition=[-0.2,0.31]\nvelocity=[0.6,0.81]\nradius=0.1\n[[ball]]\nposition=[0.2,0.7]\nradius=0.3\nfixed=true\n"},
    {"narrow_lorentz", CAROM_UNIT_CELL CAROM_POINT "[[ball]]\nposition=[0.2,0.7]\nradius=0.499\nfixed=true\n"},
    {"wide_lorentz", CAROM_UNIT_CELL CAROM_POINT "[[ball]]\nposition=[0.2,0.7]\nradius=0.02\nfixed=true\n"},
    {"three_obstacles",
     CAROM_UNIT_CELL CAROM_POINT
     "[[ball]]\nposition=[0.2,0.7]\nradius=0.2\nfixed=true\n[[ball]]\nposition=[0.55,0.4]\nradius=0.1\nfixed=true\nmass=4\n"
     "[[ball]]\nposition=[0.5,1.1]\nradius=0.05\nmass='inf'\n[[ball]]\nposition=[-0.1,0.9]\nradius=0.03\nvelocity=[0.1,-0.4]\n"},
    {"sinai_in_space",
     "dimension=3\n[space]\nkind='periodic'\nlower=[0,0,0]\nupper=[1,1.25,1]\n[[ball]]\nposition=[0.1,0.05,0.02]\nvelocity=[0.6,0.8,-0.33]\n"
     "radius=0\n[[ball]]\nposition=[0.5,0.5,0.5]\nradius=0.4\nfixed=true\n"},
    {"circle_outside",
     "dimension=2\n[space]\nkind='box'\nlower=[0,0]\nupper=[1,1]\n[[wall]]\nkind='circle'\ncentre=[0.5,0.5]\nradius=0.35\n"
     "side='outside'\n[[ball]]\nposition=[0.1,0.05]\nvelocity=[0.6,0.8]\nradius=0\n"},
    {"circle_inside",
     "dimension=2\n[[wall]]\nkind='circle'\ncentre=[0.5,0.5]\nradius=2\nside='inside'\n[[ball]]\nposition=[0.1,0.05]\n"
     "velocity=[0.6,0.8]\nradius=0.1\n[[ball]]\nposition=[1,0.05]\nvelocity=[0.1,0.8]\nradius=0.2\nmass=2\n"},
    {"polygon",
     "dimension=2\n[[wall]]\nkind='polygon'\nvertices=[[0,0],[4,0],[5,3],[1,4]]\n[[ball]]\nposition=[1,1]\nvelocity=[0.6,0.8]\nradius=0\n"
     "[[ball]]\nposition=[2,2]\nvelocity=[-0.6,0.3]\nradius=0.3\n"},
    {"lorentz_table", "[[table]]\nkind='lorentz'\nlattice='triangular'\nspacing=2.3\nradius=1\n" CAROM_POINT_AT("1.15,0.1")},
    {"lorentz_table_with_corridors", "[[table]]\nkind='lorentz'\nlattice='triangular'\nspacing=3\nradius=1\n" CAROM_POINT_AT("1.5,0.1")},
    {"narrow_lorentz_table", "[[table]]\nkind='lorentz'\nlattice='triangular'\nspacing=2.001\nradius=1\n" CAROM_POINT_AT("1.0005,0.5")},
    {"square_lorentz_table", "[[table]]\nkind='lorentz'\nlattice='square'\nspacing=2.3\nradius=1\n" CAROM_POINT_AT("1.15,0.3")},
    {"wide_lorentz_table", "[[table]]\nkind='lorentz'\nlattice='square'\nspacing=2.3\nradius=0.03\n" CAROM_POINT_AT("1.15,0.3")},
    {"sinai_table", "[[table]]\nkind='sinai'\nsize=[1,1.5]\nradius=0.35\n" CAROM_POINT_AT("0.4,0.4")},
    {"sinai_table_in_a_box", "[[table]]\nkind='sinai'\nsize=[1,1.5]\nradius=0.35\nperiodic=false\n" CAROM_POINT_AT("0.4,0.4")},
    {"disks_on_a_lorentz_table",
     "[[table]]\nkind='lorentz'\nlattice='square'\nspacing=2.3\nradius=0.8\n[[ball]]\nposition=[1.15,0.1]\nvelocity=[0.6,0.8]\nradius=0.1\n"
     "[[ball]]\nposition=[0.1,1.1]\nvelocity=[-0.6,0.3]\nradius=0.2\nmass=3\n" CAROM_POINT_AT("1.1,1.1")},
    {"crossing_circles",
     CAROM_UNIT_CELL "[[wall]]\nkind='circle'\ncentre=[5.2,-2.3]\nradius=0.3\nside='outside'\n[[wall]]\nkind='circle'\ncentre=[0.4,0.6]\n"
                     "radius=0.2\nside='outside'\n" CAROM_POINT_AT("-0.2,0.31")},
    {"circles_of_all_sizes",
     CAROM_UNIT_CELL "[[wall]]\nkind='circle'\ncentre=[0.2,0.7]\nradius=0.3\nside='outside'\n[[wall]]\nkind='circle'\ncentre=[0.6,0.3]\n"
                     "radius=0.05\nside='outside'\n[[wall]]\nkind='circle'\ncentre=[0.69,0.9]\nradius=0.001\nside='outside'\n"
                     "[[ball]]\nposition=[-0.2,0.31]\nvelocity=[0.6,0.81]\nradius=0.02\n"},
    {"flat_walls_in_periods",
     CAROM_UNIT_CELL "[[wall]]\nkind='circle'\ncentre=[0.2,0.7]\nradius=0.2\nside='outside'\n[[wall]]\nkind='segment'\nfrom=[-0.1,1.0]\n"
                     "to=[0.5,1.15]\n[[wall]]\nkind='polygon'\nvertices=[[0.5,0.3],[0.6,0.25],[0.62,0.4]]\n" CAROM_POINT_AT("-0.2,0.31")
                     "[[ball]]\nposition=[-0.2,0.6]\nvelocity=[0.6,0.81]\nradius=0.03\n"},
    {"arc_in_periods",
     CAROM_UNIT_CELL "[[wall]]\nkind='arc'\ncentre=[0.2,0.7]\nradius=0.3\nfrom_angle=0.5\nto_angle=4\n" CAROM_POINT_AT("-0.2,0.31")},
    {"sphere_in_periods",
     "dimension=3\n[space]\nkind='periodic'\nlower=[0,0,0]\nupper=[1,1.25,1]\n[[wall]]\nkind='circle'\ncentre=[0.5,0.5,0.5]\nradius=0.4\n"
     "side='outside'\n[[ball]]\nposition=[0.1,0.05,0.02]\nvelocity=[0.6,0.8,-0.33]\nradius=0\n"},
    {"stadium", "[[table]]\nkind='stadium'\nradius=1\nlength=2\n" CAROM_POINT_AT("0.3,0.1")},
    {"disks_in_a_stadium",
     "[[table]]\nkind='stadium'\nradius=1\nlength=2\n[[ball]]\nposition=[0.3,0.1]\nvelocity=[0.6,0.8]\nradius=0.25\n"
     "[[ball]]\nposition=[-0.7,0.1]\nvelocity=[0.1,-0.8]\nradius=0.1\nmass=0.2\n" CAROM_POINT_AT("0.9,-0.2")},
    {"mushroom", "[[table]]\nkind='mushroom'\ncap_radius=1\nstem_width=0.5\nstem_length=1\n" CAROM_POINT_AT("0.05,0.2")},
    {"disk_in_a_mushroom",
     "[[table]]\nkind='mushroom'\ncap_radius=1\nstem_width=0.5\nstem_length=1\n[[ball]]\nposition=[0.05,0.3]\nvelocity=[0.6,0.8]\nradius=0.1\n"},
    {"pentagon", "[[table]]\nkind='polygon'\nsides=5\nside=1\n" CAROM_POINT_AT("0.1,0.2")},
    {"rectangle_with_ties", "[[table]]\nkind='rectangle'\nsize=[2,2]\n[[ball]]\nposition=[0.25,0]\nvelocity=[1,0.75]\nradius=0\n"},
    {"wall_and_circles_in_a_box",
     "dimension=2\n[space]\nkind='box'\nlower=[0,0]\nupper=[1,1]\n[[wall]]\nkind='circle'\ncentre=[0.5,0.5]\nradius=0.2\nside='outside'\n"
     "[[wall]]\nkind='segment'\nfrom=[0.1,0.9]\nto=[0.8,0.75]\n[[wall]]\nkind='arc'\ncentre=[0.5,0.5]\nradius=0.45\nfrom_angle=3\nto_angle=5\n"
     CAROM_POINT_AT("0.5,0.05") "[[ball]]\nposition=[0.9,0.9]\nvelocity=[-0.6,0.31]\nradius=0.03\n"},
    {"annulus", "[[table]]\nkind='annulus'\ninner=0.4\nouter=1\noffset=0.3\n" CAROM_POINT_AT("-0.9,0")},
    {"disk_and_point_in_an_ellipse",
     "[[table]]\nkind='ellipse'\naxes=[3,2]\n[[ball]]\nposition=[0,0]\nvelocity=[0.6,0.8]\nradius=0\n[[ball]]\nposition=[1,0.3]\nvelocity=[0.3,-0.8]\n"
     "radius=0.2\n"},
    {"materials",
     "dimension=2\n[collision]\nrestitution=0.95\n[space]\nkind='box'\nlower=[0,0]\nupper=[10,10]\n[[gas]]\ncount=6\nradius=0.5\n"},
    {"square_of_ties",
     "dimension=2\n[space]\nkind='box'\nlower=[0,0]\nupper=[8,8]\n"
     "[[ball]]\nposition=[2,2]\nvelocity=[1,0]\nradius=0.5\n[[ball]]\nposition=[6,2]\nvelocity=[-1,0]\nradius=0.5\n"
     "[[ball]]\nposition=[2,6]\nvelocity=[0,1]\nradius=0.5\n[[ball]]\nposition=[6,6]\nvelocity=[0,-1]\nradius=0.5\n"},
    {"axis_and_rest",
     "dimension=2\n[space]\nkind='box'\nlower=[0,0]\nupper=[8,3]\n[[ball]]\nposition=[2,1]\nvelocity=[1,-0.0]\nradius=0.5\n"
     "[[ball]]\nposition=[6,1.1]\nradius=0.5\n"},
    {"touching",
     "dimension=2\n[space]\nkind='box'\nlower=[0,0]\nupper=[8,3]\n[[ball]]\nposition=[1,1]\nvelocity=[1,0.2]\nradius=0.5\n"
     "[[ball]]\nposition=[4,1]\nradius=0.5\n[[ball]]\nposition=[5,1]\nradius=0.5\n[[ball]]\nposition=[6,1]\nradius=0.5\n"},
};

#undef CAROM_UNIT_CELL
#undef CAROM_POINT
#undef CAROM_POINT_AT

/// `how` of the four: the table with and without vector instructions, the plain integrator by all pairs and by cells.
enum class By { vectors, scalars, pairs, cells };

Simulation made(const char* text, By how) {
  std::vector<Override> set;
  if (how == By::scalars) set.push_back({"engine.vectors", "false"});
  if (how == By::pairs) set.push_back({"engine.search", "\"all_pairs\""});
  if (how == By::cells) set.push_back({"engine.search", "\"cells\""});
  return Simulation(read_scene(std::string(text) + "[run]\nevents=1000000000\n", "test", set));
}

void expect_same(const Simulation& a, const Simulation& b, std::int64_t at) {
  ASSERT_EQ(a.counts().collisions(), b.counts().collisions());
  ASSERT_TRUE(same_bits(a.time().value, b.time().value)) << "after " << at;
  for (std::uint32_t i = 0; i < a.ball_count(); ++i) {
    const BallState x = a.ball(i), y = b.ball(i);
    ASSERT_EQ(x.image, y.image);
    for (std::size_t k = 0; k < x.position.size(); ++k) {
      ASSERT_TRUE(same_bits(x.position[k].value, y.position[k].value)) << "ball " << i << " after " << at;
      ASSERT_TRUE(same_bits(x.velocity[k].value, y.velocity[k].value)) << "ball " << i << " after " << at;
    }
  }
  const Summary x = a.summary(), y = b.summary();
  ASSERT_EQ(x.events.ball_wall, y.events.ball_wall);
  ASSERT_EQ(x.events.ties, y.events.ties);
  for (const auto& [p, q] : {std::pair{x.energy.final, y.energy.final}, std::pair{x.energy.dissipated, y.energy.dissipated},
                             std::pair{x.exactness.max_gap_error, y.exactness.max_gap_error},
                             std::pair{x.exactness.max_gap_error_relative, y.exactness.max_gap_error_relative}})
    ASSERT_TRUE(same_bits(p.value, q.value)) << p.value << " against " << q.value << " after " << at;
  ASSERT_EQ(x.exactness.clamped, 0);
  ASSERT_EQ(x.exactness.singular, y.exactness.singular);
  ASSERT_EQ(x.exactness.unresolved, y.exactness.unresolved);
}

class FewBallsIn : public ::testing::TestWithParam<Named> {};

TEST_P(FewBallsIn, fly_as_in_the_plain_integrator) {
  const char* const text = GetParam().text;
  for (const By how : {By::vectors, By::scalars}) {
    Simulation table = made(text, how), plain = made(text, how == By::vectors ? By::pairs : By::cells);
    ASSERT_EQ(table.composition().queue, "table of meetings");
    ASSERT_EQ(plain.composition().queue, "heap");
    std::int64_t done = 0;
    for (std::int64_t step = 1; done < scaled_count(4000); done += step, step += 1 + step / 2) {
      ASSERT_EQ(table.advance(std::nullopt, step), plain.advance(std::nullopt, step));
      expect_same(table, plain, done + step);
      if (HasFatalFailure()) return;
      if (step % 7 == 0) {
        EXPECT_EQ(table.audit().overlaps, 0);
      }
    }
  }
}

TEST_P(FewBallsIn, are_recorded_as_by_the_plain_integrator) {
  Simulation table = made(GetParam().text, By::vectors), plain = made(GetParam().text, By::pairs);
  std::vector<Collision> one, other;
  for (int k = 0; k < 4; ++k) {
    table.advance(std::nullopt, 300, [&](const Collision& c) { one.push_back(c); });
    plain.advance(std::nullopt, 300, [&](const Collision& c) { other.push_back(c); });
    table.advance(std::nullopt, 11 * k);  // what nobody looks at in between
    plain.advance(std::nullopt, 11 * k);
  }
  EXPECT_GE(one.size(), 100u);
  ASSERT_EQ(difference(one, other), "");
  for (std::size_t n = 0; n < one.size(); ++n) {
    const Collision &a = one[n], &b = other[n];
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_TRUE(same_bits(a.normal[k], b.normal[k])) << "collision " << n;
      ASSERT_TRUE(same_bits(a.point[k], b.point[k])) << "collision " << n;
    }
    for (const auto& [p, q] : {std::pair{a.curvature, b.curvature}, std::pair{a.arclength, b.arclength}, std::pair{a.time, b.time},
                               std::pair{a.restitution, b.restitution}})
      ASSERT_TRUE(same_bits(p, q)) << p << " against " << q << " in collision " << n;
  }
}

// A state is that of the run, whoever wrote it, and so is what happens up to a moment.
TEST_P(FewBallsIn, go_on_from_each_others_states) {
  Simulation table = made(GetParam().text, By::vectors), plain = made(GetParam().text, By::pairs);
  table.advance(std::nullopt, 277);
  plain.advance(std::nullopt, 277);
  Simulation from_plain = made(GetParam().text, By::vectors), from_table = made(GetParam().text, By::pairs);
  from_plain.restore(plain.state());
  from_table.restore(table.state());
  const Number later = Number(plain.time().value * 2);
  ASSERT_EQ(from_plain.advance(later), from_table.advance(later));
  expect_same(from_plain, from_table, 277);
  from_plain.reverse();
  from_table.reverse();
  from_plain.advance(std::nullopt, 500);
  from_table.advance(std::nullopt, 500);
  expect_same(from_plain, from_table, 777);
}

INSTANTIATE_TEST_SUITE_P(Scenes, FewBallsIn, ::testing::ValuesIn(scenes), [](const auto& named) { return std::string(named.param.name); });

// Random boxes and cells of two to twelve balls of unequal radii and masses.
TEST(FewBalls, fly_as_in_the_plain_integrator_whatever_the_scene) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Dice dice(seed);
    const int dimension = seed % 3 == 0 ? 3 : 2, balls = 2 + static_cast<int>(seed % 11);
    Scene scene = mixed_box(dimension, balls, 6.0 + dice.unit(), seed, 0.2);
    if (seed % 2 == 0) scene.space.kind = SpaceKind::periodic;
    if (seed % 5 == 0) scene.balls[0].fixed = true;
    if (seed % 5 == 0) scene.balls[0].velocity = Coordinates(static_cast<std::size_t>(dimension), 0.0);
    Scene by_pairs = scene;
    by_pairs.engine.search = SearchKind::all_pairs;
    Simulation table(scene), plain(by_pairs);
    ASSERT_EQ(plain.composition().queue, "heap");
    for (const std::int64_t step : {1, 10, 100, 700}) {
      ASSERT_EQ(table.advance(std::nullopt, step), plain.advance(std::nullopt, step));
      expect_same(table, plain, step);
      if (HasFatalFailure()) FAIL() << "seed " << seed;
    }
    EXPECT_EQ(table.audit().overlaps, 0);
  }
}

// What has nothing to meet ends as it does in the plain integrator.
TEST(FewBalls, end_where_nothing_is_left) {
  const char* const alone = "dimension=2\n[[ball]]\nposition=[0,0]\nvelocity=[1,0.5]\nradius=0.2\n[[ball]]\nposition=[3,1]\n";
  const char* const corridor =
      "dimension=2\n[space]\nkind='periodic'\nlower=[0,0]\nupper=[1,1]\n[[ball]]\nposition=[0.1,0.95]\nvelocity=[1,0]\nradius=0\n"
      "[[ball]]\nposition=[0.5,0.5]\nradius=0.3\nfixed=true\n";
  for (const char* text : {alone, corridor}) {
    Simulation table = made(text, By::vectors), plain = made(text, By::pairs);
    EXPECT_EQ(table.advance(Number(5000.0)), plain.advance(Number(5000.0)));
    EXPECT_EQ(table.advance(std::nullopt, 5), plain.advance(std::nullopt, 5));
    expect_same(table, plain, 0);
  }
}

TEST(FewBallsChoice, is_made_from_the_scene) {
  const auto queue = [](const std::string& text) {
    return Simulation(read_scene(text + "[run]\nevents=10\n", "test")).composition().queue;
  };
  EXPECT_EQ(queue("dimension=2\n[[gas]]\ncount=13\npacking_fraction=0.2\nradius=0.5\n"), "heap");
  EXPECT_EQ(queue("dimension=2\n[motion]\nacceleration=[0,-1]\n[space]\nkind='box'\nlower=[0,0]\nupper=[9,9]\n[[gas]]\n"
                  "count=5\nradius=0.5\n"),
            "heap");
  EXPECT_EQ(queue("dimension=2\n[collision]\nlaw='merge'\n[space]\nkind='box'\nlower=[0,0]\nupper=[9,9]\n[[gas]]\n"
                  "count=5\nradius=0.5\n"),
            "heap");
}

}  // namespace
}  // namespace carom
