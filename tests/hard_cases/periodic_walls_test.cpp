// Walls that stand in every period: none is missed in the longest corridor or over the edge of the cell, and what is found
// does not depend on who looks for it.

#include <cmath>

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

Scene cell(double width, double height) {
  Scene scene = open_space(2);
  scene.space.kind = SpaceKind::periodic;
  scene.space.lower = {0.0, 0.0};
  scene.space.upper = {width, height};
  return scene;
}

/// Circles, a polygon and a segment over the edges of a cell, and balls between them.
Scene crowded(double radius) {
  Scene scene = cell(10.0, 8.0);
  scene.walls = {circle({0.0, 0.0}, 1.0, WallSide::outside), circle({5.0, 7.5}, 0.8, WallSide::outside),
                 polygon({{9.0, 3.0}, {11.0, 3.5}, {10.5, 5.0}}), segment({3.0, -1.0}, {4.0, 1.5})};
  Dice dice(7);
  for (const auto& [x, y] : {std::pair{2.0, 3.0}, {4.0, 3.0}, {6.0, 3.0}, {2.0, 5.0}, {4.0, 5.0}, {6.5, 5.0}, {7.5, 1.0}, {7.5, 6.5}}) {
    const double vx = dice.between(-1.0, 1.0), vy = dice.between(-1.0, 1.0);
    scene.balls.push_back(ball({x, y}, {vx, vy}, radius, dice.between(1.0, 3.0)));
  }
  return scene;
}

// Disks of radius 1 on a square lattice of spacing 4; a point at height 1.9 in the corridor 1 < y < 3 rises by s = 4e-6 for
// each length along it. It passes below the disks at y = 4 until one is nearer to its path than 1.
TEST(PeriodicWalls, the_end_of_a_long_corridor_is_found) {
  Scene scene = cell(4.0, 4.0);
  scene.walls = {circle({0.0, 0.0}, 1.0, WallSide::outside)};
  const long double s = 4e-6, slant = std::sqrt(1 + s * s);
  scene.balls = {ball({1.5, 1.9}, {1.0, 4e-6}, 0.0)};
  const Result result = watched_run(scene, {.events = 3});
  long double k = std::floor((2.1L - slant) / (4 * s)), time = 0;
  for (;; ++k) {
    const long double x = 4 * k - 1.5L, y = 2.1L, aside = (y - s * x) / slant;  // of the centre, seen from the start
    if (aside >= 1) continue;
    time = ((x + s * y) / slant - std::sqrt(1 - aside * aside)) / slant;
    break;
  }
  ASSERT_EQ(result.log.size(), 3u);
  EXPECT_GT(k, 5e4);
  // The hit grazes: 1 - aside is 2e-5 or less, so that an error in the height counts some hundredfold.
  EXPECT_NEAR(result.log[0].time, static_cast<double>(time), 1e-8);
  EXPECT_EQ(result.log[0].ball.image[0], static_cast<std::int64_t>(k) - 1);
  EXPECT_LT(std::abs(result.log[0].gap), 1e-11);
}

// What flies along the corridor for ever meets nothing: the run says so.
TEST(PeriodicWalls, a_corridor_without_end_ends_the_run) {
  Scene scene = cell(4.0, 4.0);
  scene.walls = {circle({0.0, 0.0}, 1.0, WallSide::outside)};
  scene.balls = {ball({1.5, 1.9}, {1.0, 0.0}, 0.0), ball({1.5, 2.5}, {0.0, 0.0}, 0.1)};
  EXPECT_EQ(run(scene, 1).stop, Stop::no_events_left);
}

// A circle is a ball that never moves, up to rounding: the first twelve collisions are the same within 1e-9. (Each multiplies
// an error by about ten.)
TEST(PeriodicWalls, act_as_fixed_balls_do) {
  Scene walls = cell(3.0, 2.5), balls = walls;
  const std::vector<Coordinates> centres{{0.0, 0.0}, {1.5, 1.25}};
  balls.balls = walls.balls = {ball({1.25, 0.25}, {0.6, 0.75}, 0.125)};
  for (const Coordinates& c : centres) {
    walls.walls.push_back(circle(c, 0.5, WallSide::outside));
    balls.balls.push_back(fixed_ball(c, 0.5));
  }
  const Result a = run(walls, 12), b = run(balls, 12);
  ASSERT_EQ(a.log.size(), 12u);
  for (std::size_t k = 0; k < 12; ++k) {
    EXPECT_EQ(a.log[k].kind, EventKind::ball_wall);
    EXPECT_EQ(a.log[k].partner.number + 1, b.log[k].partner.number);
    EXPECT_NEAR(a.log[k].time, b.log[k].time, 1e-13 * std::pow(4.0, k));
    for (std::size_t c = 0; c < 2; ++c) {
      EXPECT_NEAR(a.log[k].ball.position[c], b.log[k].ball.position[c], 1e-13 * std::pow(4.0, k));
      EXPECT_EQ(a.log[k].ball.image[c], b.log[k].ball.image[c]);
    }
  }
}

// Where the cell begins is a matter of names: shifted by a part of it, all else stays, and walls reach over its edges.
TEST(PeriodicWalls, do_not_know_where_the_cell_begins) {
  const Scene scene = crowded(0.25);
  const Result base = run(scene, 12);
  for (const double shift : {0.5, 2.0, 3.75, -6.25}) {
    Scene moved = scene;
    moved.space.lower = {-shift, -shift};
    moved.space.upper = {10.0 - shift, 8.0 - shift};
    const Result other = run(moved, 12);
    for (std::size_t k = 0; k < 12; ++k) {
      EXPECT_EQ(other.log[k].ball.number, base.log[k].ball.number) << "shift " << shift << " collision " << k;
      EXPECT_EQ(other.log[k].partner.number, base.log[k].partner.number);
      EXPECT_NEAR(other.log[k].time, base.log[k].time, 1e-10);
    }
  }
}

TEST(PeriodicWalls, are_never_entered) {
  for (const double radius : {0.25, 0.0}) {
    const Result result = watched_run(crowded(radius), {.events = scaled_count(3000), .stride = 50});
    EXPECT_EQ(result.stop, Stop::events);
  }
}

TEST(PeriodicWalls, are_the_same_for_every_search_and_queue) {
  for (const double radius : {0.25, 0.0})
    for (const bool together : {false, true}) {
      Scene scene = crowded(radius);
      if (together) scene.collision.simultaneous = Simultaneous::symmetric;
      const Result base = run(scene, 500);
      for (const SearchKind search : {SearchKind::all_pairs, SearchKind::cells})
        for (const QueueKind queue : {QueueKind::heap, QueueKind::calendar}) {
          scene.engine.search = search;
          scene.engine.queue = queue;
          EXPECT_EQ(difference(base.log, run(scene, 500).log), "");
        }
      scene.engine = {};
      std::vector<Collision> log;
      Simulation reference = Simulation::reference(scene);
      reference.advance(std::nullopt, 500, [&](const Collision& c) { log.push_back(c); });
      EXPECT_EQ(difference(base.log, log), "");
    }
}

// Put back at any collision, it goes on the same: contacts know the period of the wall.
TEST(PeriodicWalls, a_checkpoint_goes_on_bit_for_bit) {
  const Scene scene = crowded(0.25);
  const Result base = run(scene, 300);
  std::vector<Collision> log;
  Simulation simulation(scene);
  const auto note = [&](const Collision& c) { log.push_back(c); };
  for (int part = 0; part < 30; ++part) {
    simulation.advance(std::nullopt, 10, note);
    const std::string state = simulation.state();
    simulation = Simulation(scene);
    simulation.restore(state);
  }
  EXPECT_EQ(difference(base.log, log), "");
}

// A channel of two segments that span the cell: the end of one period is the beginning of the next. A point aimed at that
// joint, and beside it, stays in the channel; on the vertex itself it is sent back.
TEST(PeriodicWalls, join_over_the_edge_without_a_gap) {
  for (const double offset : {0.0, 1e-16, -1e-16, 1e-12, -1e-12, 1e-8, -1e-8})
    for (const double x : {0.1, 0.5, 0.7, 1.3}) {
      Scene scene = cell(8.0, 4.0);
      scene.walls = {segment({0.0, 1.0}, {8.0, 1.0}), segment({0.0, 2.0}, {8.0, 2.0})};
      scene.balls = {ball({x, 1.5}, {8.0 - x + offset, -0.5}, 0.0)};
      const Result result = watched_run(scene, {.events = 200, .stride = 20});
      ASSERT_EQ(result.log.size(), 200u) << "it got out: offset " << offset;
      for (std::size_t k = 0; k + 1 < result.log.size(); ++k) {
        const double y = result.log[k].ball.position[1];
        EXPECT_TRUE(y == 1.0 || y == 2.0);
        EXPECT_NE(result.log[k + 1].ball.position[1], y);  // to the other side, sent back or not
      }
      EXPECT_EQ(result.summary.events.ball_ball, 0);
    }
}

TEST(PeriodicWalls, stand_in_space_too) {
  Scene scene = open_space(3);
  scene.space.kind = SpaceKind::periodic;
  scene.space.lower = {0.0, 0.0, 0.0};
  scene.space.upper = {3.0, 3.0, 3.0};
  scene.walls = {circle({0.0, 0.0, 0.0}, 0.9, WallSide::outside)};
  scene.balls = {ball({1.5, 1.5, 1.5}, {0.3, 0.5, 0.7}, 0.1), ball({0.4, 1.5, 1.5}, {0.3, -0.5, 0.7}, 0.1),
                 ball({1.5, 0.4, 1.5}, {-0.3, 0.5, 0.1}, 0.0)};
  const Result base = watched_run(scene, {.events = 400, .stride = 20});
  EXPECT_GT(base.summary.events.ball_wall, 300);
  scene.engine.search = SearchKind::cells;
  EXPECT_EQ(difference(base.log, run(scene, 400).log), "");
}

TEST(PeriodicWalls, what_cannot_stand_there_is_refused) {
  Scene scene = cell(4.0, 4.0);
  scene.balls = {ball({1.0, 1.0}, {1.0, 0.0}, 0.1)};
  const auto with = [&](WallSpec w, LawKind law = LawKind::restitution) {
    Scene s = scene;
    s.walls = {std::move(w)};
    s.collision.law = law;
    return refusals(s);
  };
  WallSpec moving = segment({0.0, 3.0}, {4.0, 3.0});
  moving.velocity = {0.0, 0.1};
  EXPECT_EQ(with(plane({0.0, 0.0}, {0.0, 1.0})).size(), 1u);
  EXPECT_EQ(with(moving).size(), 1u);
  EXPECT_EQ(with(circle({3.0, 3.0}, 0.5, WallSide::outside), LawKind::stick).size(), 1u);
  EXPECT_EQ(with(circle({2.0, 2.0}, 1.5, WallSide::inside)).size(), 1u);
  EXPECT_TRUE(with(circle({3.0, 3.0}, 0.5, WallSide::outside)).empty());
  // A start inside a wall of the next period.
  EXPECT_EQ(with(circle({5.0, 1.0}, 0.5, WallSide::outside)).size(), 1u);
}

}  // namespace
}  // namespace carom
