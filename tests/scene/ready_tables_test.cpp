// [[table]]: what each kind stands for, with numbers that are exact or rounded once, and joints that are the same numbers.

#include "carom/scene/tables.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "carom/core/rational.hpp"
#include "carom/scene/read.hpp"
#include "carom/sim/simulation.hpp"
#include "full_scene.hpp"

namespace carom {
namespace {

Scene with_table(const std::string& keys) {
  return read_scene("[[table]]\n" + keys + "\n[[ball]]\nposition = [0.25, 0.125]\nradius = 0\n[run]\nevents = 1\n", "test.toml");
}

std::vector<WallKind> kinds(const Scene& s) {
  std::vector<WallKind> all;
  for (const WallSpec& w : s.walls) all.push_back(w.kind);
  return all;
}

double distance(const Coordinates& a, const Coordinates& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

TEST(ReadyTables, stand_for_walls_in_a_stated_order) {
  const auto arc = WallKind::arc, segment = WallKind::segment, polygon = WallKind::polygon, circle = WallKind::circle;
  const std::vector<std::pair<std::string, std::vector<WallKind>>> tables{
      {"kind = \"rectangle\"\nsize = [2, 1]", {polygon}},
      {"kind = \"circle\"\nradius = 1", {circle}},
      {"kind = \"ellipse\"\naxes = [2, 1]", {WallKind::ellipse}},
      {"kind = \"stadium\"\nradius = 1\nlength = 2", {segment, arc, segment, arc}},
      {"kind = \"mushroom\"\ncap_radius = 1\nstem_width = 0.5\nstem_length = 1", {arc, segment, segment, segment, segment, segment}},
      {"kind = \"mushroom\"\ncap_radius = 1\nstem_width = 2\nstem_length = 1", {arc, segment, segment, segment}},
      {"kind = \"sinai\"\nsize = 2\nradius = 0.5", {circle}},
      {"kind = \"lorentz\"\nlattice = \"square\"\nspacing = 2.5\nradius = 1", {circle}},
      {"kind = \"lorentz\"\nlattice = \"triangular\"\nspacing = 2.5\nradius = 1", {circle, circle}},
      {"kind = \"polygon\"\nsides = 5\nside = 1", {polygon}},
      {"kind = \"triangle\"\nlengths = [3, 4, 5]", {polygon}},
      {"kind = \"wedge\"\nlength = 1\nangle = 1", {segment, segment}},
      {"kind = \"cardioid\"\nscale = 1", {WallKind::curve}},
      {"kind = \"pinball\"\nspacing = 6\nradius = 1", {circle, circle, circle, polygon}},
      {"kind = \"annulus\"\ninner = 0.1\nouter = 1\noffset = -0.5", {circle, circle}},
      {"kind = \"pool\"\nlength = 2.54", {polygon}}};
  for (const auto& [keys, expected] : tables) {
    const Scene s = with_table(keys);
    EXPECT_EQ(kinds(s), expected) << keys;
    for (const WallSpec& w : s.walls) EXPECT_EQ(w.table, 0);
    EXPECT_EQ(tables_explained(s).size(), 1u);
  }
}

TEST(ReadyTables, follow_the_walls_of_the_scene) {
  const Scene s = read_scene(R"([[wall]]
kind = "circle"
centre = [9, 9]
radius = 0.1
side = "outside"
[[table]]
kind = "rectangle"
size = [1, 1]
restitution = 0.5
[[table]]
kind = "rectangle"
size = [4, 4]
centre = [9, 9]
[[ball]]
position = [0, 0]
radius = 0.1
[run]
events = 1
)", "test.toml");
  ASSERT_EQ(s.walls.size(), 3u);
  EXPECT_EQ(s.walls[0].table, -1);
  EXPECT_EQ(s.walls[1].table, 0);
  EXPECT_EQ(s.walls[1].restitution->value, 0.5);
  EXPECT_EQ(s.walls[2].table, 1);
  EXPECT_EQ(tables_explained(s)[1], "table 1 (\"rectangle\"), wall 2: cushion");
}

// The end of one piece is the beginning of the next, number by number, turned or not.
TEST(ReadyTables, pieces_join_in_the_same_numbers) {
  for (const std::string turned : {"", "\nangle = 0.7\ncentre = [0.1, \"1/3\"]"})
    for (const std::string keys : {"kind = \"stadium\"\nradius = 1.1\nlength = \"1/3\"",
                                   "kind = \"mushroom\"\ncap_radius = 1.1\nstem_width = 0.3\nstem_length = 1",
                                   "kind = \"mushroom\"\ncap_radius = 1.1\nstem_width = 2.2\nstem_length = 1"}) {
      const Scene s = with_table(keys + turned);
      for (std::size_t k = 0; k < s.walls.size(); ++k) {
        const WallSpec &a = s.walls[k], &b = s.walls[(k + 1) % s.walls.size()];
        for (std::size_t c = 0; c < 2; ++c) {
          EXPECT_EQ(a.to[c].value, b.from[c].value) << keys;
          EXPECT_EQ(exact(a.to[c]), exact(b.from[c])) << keys;
        }
        if (a.kind != WallKind::arc) continue;
        // Angles and ends agree to rounding: both are rounded once from the same decimals.
        for (const auto& [end, angle] : {std::pair{a.from, a.from_angle}, std::pair{a.to, a.to_angle}}) {
          EXPECT_NEAR(end[0], a.centre[0] + a.radius * std::cos(angle), 1e-15);
          EXPECT_NEAR(end[1], a.centre[1] + a.radius * std::sin(angle), 1e-15);
        }
      }
    }
}

TEST(ReadyTables, numbers_are_exact_where_they_can_be) {
  const Scene s = with_table("kind = \"rectangle\"\nsize = [1, \"1/3\"]\ncentre = [0.1, 0.2]");
  // 0.2 - 1/6 = 1/30 and 0.1 + 1/2 = 3/5, not the sums of rounded numbers.
  EXPECT_EQ(exact(s.walls[0].vertices[0][1]), Rational(1) / 30);
  EXPECT_EQ(exact(s.walls[0].vertices[1][0]), Rational(3) / 5);
  EXPECT_EQ(s.walls[0].vertices[0][1].value, 1.0 / 30);
  EXPECT_EQ(s.walls[0].vertices[1][0].value, 0.6);
}

// A pentagon of side 1 has circumradius sqrt((5 + sqrt 5) / 10); the compiler rounds the decimals once.
TEST(ReadyTables, irrational_numbers_are_rounded_once) {
  const Scene pentagon = with_table("kind = \"polygon\"\nsides = 5\nside = 1");
  const std::vector<Coordinates>& v = pentagon.walls[0].vertices;
  EXPECT_EQ(v[3][1].value, 0.85065080835203993218154049706301107224);
  EXPECT_EQ(v[3][0].value, 0.0);
  EXPECT_EQ(v[0][1].value, v[1][1].value);  // the lowest side is level
  for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR(distance(v[k], v[(k + 1) % 5]), 1.0, 3e-16);
  const Scene square = with_table("kind = \"polygon\"\nsides = 4\nside = 1");
  for (const Coordinates& corner : square.walls[0].vertices)
    for (const Number& x : corner) EXPECT_EQ(std::abs(x.value), 0.5);
  // Digits beyond a double are in the text: a table in 50 digits is one.
  EXPECT_EQ(v[3][1].text.substr(0, 52), "0.85065080835203993218154049706301107224040140376481");
}

TEST(ReadyTables, a_triangle_has_its_sides_and_its_centroid_at_the_centre) {
  const Scene s = with_table("kind = \"triangle\"\nlengths = [3, 4, 5]\ncentre = [1, 2]");
  const std::vector<Coordinates>& v = s.walls[0].vertices;
  EXPECT_DOUBLE_EQ(distance(v[0], v[1]), 3.0);
  EXPECT_DOUBLE_EQ(distance(v[1], v[2]), 4.0);
  EXPECT_DOUBLE_EQ(distance(v[2], v[0]), 5.0);
  for (std::size_t c = 0; c < 2; ++c) EXPECT_DOUBLE_EQ((v[0][c] + v[1][c] + v[2][c]) / 3, c == 0 ? 1.0 : 2.0);
}

TEST(ReadyTables, lattices_of_disks_bring_their_cell) {
  const Scene triangular = with_table("kind = \"lorentz\"\nlattice = \"triangular\"\nspacing = 2.5\nradius = 1\ncentre = [1, 0]");
  EXPECT_EQ(triangular.space.kind, SpaceKind::periodic);
  EXPECT_EQ(triangular.space.lower[0].value, -0.25);
  EXPECT_EQ(triangular.space.upper[0].value, 2.25);
  // Every disk has six neighbours `spacing` away: two in its row, four half an edge aside and half the other edge up or down.
  const double height = triangular.space.upper[1] - triangular.space.lower[1];
  EXPECT_DOUBLE_EQ(height, 2.5 * std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(distance(triangular.walls[0].centre, triangular.walls[1].centre), 2.5);
  EXPECT_EQ(triangular.walls[1].centre[0].value, triangular.space.upper[0].value);
  EXPECT_EQ(triangular.walls[1].centre[1].value, triangular.space.upper[1].value);

  const Scene sinai = with_table("kind = \"sinai\"\nsize = [2, 3]\nradius = 0.1\nperiodic = false\nrestitution = 0.5\ncentre = [1, 1]");
  EXPECT_EQ(sinai.space.kind, SpaceKind::box);
  EXPECT_EQ(sinai.space.lower[1].value, -0.5);
  EXPECT_EQ(sinai.space.restitution->value, 0.5);
}

TEST(ReadyTables, a_cradle_is_a_row_of_touching_balls) {
  for (const std::string dimension : {"1", "2"}) {
    const Scene s = read_scene("dimension = " + dimension + "\n[[table]]\nkind = \"cradle\"\ncount = 5\nradius = 0.1\n[run]\nevents = 1\n",
                               "test.toml");
    ASSERT_EQ(s.balls.size(), 5u);
    for (std::size_t k = 0; k < 5; ++k) {
      EXPECT_EQ(s.balls[k].position.size(), dimension == "1" ? 1u : 2u);
      EXPECT_EQ(exact(s.balls[k].position[0]), Rational(2 * static_cast<int>(k) - 4) / 10);
    }
    EXPECT_EQ(Simulation(s).audit().overlaps, 0);
  }
}

TEST(ReadyTables, are_put_into_a_scene_made_in_code) {
  Scene s;
  s.run.events = 10;
  TableSpec t;
  t.kind = TableKind::rectangle;
  t.size = {2.0, 1.0};
  s.tables = {t, t};
  s.tables[1].centre = {5.0, 0.0};
  BallSpec b;
  b.radius = 0.1;
  b.position = {0.0, 0.0};
  b.velocity = {1.0, 0.5};
  s.balls = {b};
  EXPECT_EQ(Simulation(s).wall_count(), 2u);
  s.tables[1].size = {2.0, -1.0};
  EXPECT_THROW((void)Simulation(s), InputError);
}

struct Wrong {
  std::string keys;  // of [[table]], from line 2 on
  int line;
  std::string what;
};

TEST(ReadyTables, what_is_wrong_is_named_with_its_line) {
  const std::vector<Wrong> all{
      {"kind = \"stadion\"", 2, "table.0.kind is \"stadion\""},
      {"kind = \"stadium\"\nradius = 1", 1, "table.0.length is missing"},
      {"kind = \"stadium\"\nradius = -1\nlength = 1", 3, "table.0.radius is -1"},
      {"kind = \"stadium\"\nradius = 1\nlength = 1\nsides = 4", 5, "table.0.sides has no meaning here"},
      {"kind = \"circle\"\nradius = 1\nradios = 4", 4, "unknown key \"radios\" in table.0"},
      {"kind = \"rectangle\"\nsize = [1]", 3, "table.0.size has 1 number"},
      {"kind = \"rectangle\"\nsize = [1, 0]", 3, "table.0.size holds 0"},
      {"kind = \"ellipse\"\naxes = [1, -2]", 3, "table.0.axes holds -2"},
      {"kind = \"mushroom\"\ncap_radius = 1\nstem_width = 3\nstem_length = 1", 4, "table.0.stem_width is 3"},
      {"kind = \"sinai\"\nsize = 1\nradius = 0.5", 4, "table.0.radius is 0.5"},
      {"kind = \"lorentz\"\nlattice = \"cubic\"\nspacing = 3\nradius = 1", 3, "table.0.lattice is \"cubic\""},
      {"kind = \"lorentz\"\nlattice = \"square\"\nspacing = 1.5\nradius = 1", 4, "table.0.spacing is 1.5"},
      {"kind = \"polygon\"\nsides = 2\nside = 1", 3, "table.0.sides is 2"},
      {"kind = \"triangle\"\nlengths = [1, 1, 3]", 3, "table.0.lengths holds 3"},
      {"kind = \"wedge\"\nlength = 1\nangle = 4", 4, "table.0.angle is 4"},
      {"kind = \"annulus\"\ninner = 0.6\nouter = 1\noffset = 0.5", 3, "table.0.inner is 0.6"},
      {"kind = \"circle\"\nradius = 1\ncentre = [1, 2, 3]", 4, "table.0.centre has 3 components"},
      {"kind = \"circle\"\nradius = 1\nmaterial = \"felt\"", 4, "table.0.material is \"felt\""},
      {"kind = \"sinai\"\nsize = 4\nradius = 1\n[space]\nkind = \"box\"\nlower = [0, 0]\nupper = [1, 1]", 2,
       "table.0.kind is \"sinai\""}};
  for (const Wrong& w : all) {
    const std::string text = "[[table]]\n" + w.keys + "\n[[ball]]\nposition = [0, 0]\nradius = 0\n[run]\nevents = 1\n";
    const std::vector<Problem> problems = testing::reading(text).problems;
    ASSERT_EQ(problems.size(), 1u) << w.keys << "\n" << testing::listed(problems);
    EXPECT_EQ(problems[0].what, w.what);
    EXPECT_EQ(problems[0].line, w.line) << w.what;
  }
}

// A ball that starts outside is named with its place; on the edge it is inside.
TEST(ReadyTables, a_start_outside_is_refused) {
  const auto refusal = [](const std::string& table, const std::string& position) -> std::string {
    const Scene s = read_scene("[[table]]\n" + table + "\n[[ball]]\nposition = " + position +
                                   "\nvelocity = [0.3, 1]\nradius = 0\n[run]\nevents = 1\n", "test.toml");
    try {
      (void)Simulation(s);
    } catch (const InputError& e) {
      return e.problems().front().text();
    }
    return "";
  };
  const std::string square = "kind = \"rectangle\"\nsize = [2, 2]";
  EXPECT_EQ(refusal(square, "[0.5, 0.5]"), "");
  EXPECT_EQ(refusal(square, "[0.5, -1]"), "");
  EXPECT_EQ(refusal(square, "[1.5, 0.5]"),
            "test.toml:4: a ball starts at [1.5, 0.5], outside of the table (the table lies between [-1, -1] and [1, 1]). Move "
            "the ball into it");
  const std::string pinball = "kind = \"pinball\"\nspacing = 6\nradius = 1";
  EXPECT_EQ(refusal(pinball, "[0, 0]"), "");
  EXPECT_NE(refusal(pinball, "[0, 5]"), "");
  EXPECT_NE(refusal(pinball, "[0, 3.3]"), "");  // within a disk
  const std::string annulus = "kind = \"annulus\"\ninner = 0.2\nouter = 1\noffset = 0.5";
  EXPECT_EQ(refusal(annulus, "[0, 0.9]"), "");
  EXPECT_NE(refusal(annulus, "[0.5, 0.1]"), "");
  EXPECT_NE(refusal(annulus, "[0.9, 0.9]"), "");
}

}  // namespace
}  // namespace carom
