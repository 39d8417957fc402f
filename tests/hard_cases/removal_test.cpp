// Row 22: a ball leaves while its events are queued. Merging removes balls; their numbers are not given to others, what was
// predicted with them is void, and the count of what is left, its mass and its momentum agree.

#include <set>

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

Scene falling_in(int dimension, int balls, std::uint64_t seed) {
  Scene scene = mixed_box(dimension, balls, 12.0, seed, 0.4);
  scene.space = SpaceSpec{};
  scene.collision.law = LawKind::merge;
  for (BallSpec& b : scene.balls)
    for (std::size_t k = 0; k < b.position.size(); ++k) b.velocity[k] = 0.2 * b.velocity[k] - 0.3 * (b.position[k] - 6.0);
  return scene;
}

TEST(Removal, leaves_no_stale_number) {
  for (int d = 2; d <= 3; ++d)
    for (std::uint64_t seed = 220; seed < 226; ++seed) {
      const Scene scene = falling_in(d, d == 2 ? 36 : 27, seed);
      double mass = 0.0;
      for (const BallSpec& b : scene.balls) mass += b.mass;
      // Audited at the end: a ball that has just grown may overlap others, which merge with it at the same instant.
      const Result result = watched_run(scene, {.events = 1000, .until = 100.0, .stride = 1000, .energy_error = 1e-14});
      std::set<std::uint32_t> gone;
      for (const Collision& c : result.log) {
        EXPECT_LT(c.ball.number, c.partner.number);
        EXPECT_FALSE(gone.contains(c.ball.number)) << "ball " << c.ball.number << " had left";
        EXPECT_FALSE(gone.contains(c.partner.number));
        gone.insert(c.partner.number);  // the smaller number survives
      }
      EXPECT_GT(gone.size(), 5u);
      EXPECT_EQ(result.balls.size() + gone.size(), scene.balls.size());
      double left = 0.0;
      for (const BallState& b : result.balls) {
        EXPECT_FALSE(gone.contains(b.index));
        left += b.mass;
      }
      EXPECT_NEAR(left, mass, 1e-12 * mass);
      EXPECT_LE(result.summary.momentum.relative_error.value(), 1e-14);
    }
}

// Any search and queue: the same removals.
TEST(Removal, is_the_same_in_every_search_and_queue) {
  const Scene scene = falling_in(2, 49, 229);
  const Result one = run_until(scene, 50.0);
  std::vector<Collision> log;
  Simulation other = Simulation::reference(scene);
  other.advance(Number(50.0), std::nullopt, [&](const Collision& c) { log.push_back(c); });
  EXPECT_EQ(difference(one.log, log), "");
  EXPECT_GT(log.size(), 10u);
}

// A light ball that a heavy one swallows takes the place of the two: their centre of mass, in another cell of a grid. Whom it
// overlaps there merges with it at the same instant, whichever search is used.
TEST(Removal, a_merged_ball_is_looked_for_where_it_is) {
  Scene scene = open_space(1);
  scene.space.kind = SpaceKind::periodic;
  scene.space.lower = {0.0};
  scene.space.upper = {8.0};
  scene.collision.law = LawKind::merge;
  scene.balls = {ball({6.8797242902267906}, {-0.5}, 0.2227083687733284), fixed_ball({6.348725653737887}, 0.30829026771557555),
                 ball({2.25}, {-0.5}, 0.17), ball({5.7111870600339385}, {-0.5}, 0.14358745052577432),
                 ball({1.25}, {0.5}, 0.16), ball({7.725640694873691}, {0.6}, 0.5457108530986887)};
  std::vector<std::vector<Collision>> logs;
  for (const SearchKind search : {SearchKind::all_pairs, SearchKind::cells}) {
    scene.engine.search = search;
    logs.push_back(watched_run(scene, {.until = 20.0, .stride = 1000}).log);
  }
  EXPECT_EQ(difference(logs[0], logs[1]), "");
  ASSERT_GE(logs[0].size(), 2u);
  EXPECT_EQ(logs[0][1].time, 0.0);
  EXPECT_EQ(logs[0][1].partner.number, 3u);
}

// The ball that leaves was about to hit a third one: that meeting is off, and the third meets what came of the two.
TEST(Removal, calls_off_what_was_predicted) {
  Scene scene = open_space(2);
  scene.collision.law = LawKind::merge;
  scene.balls = {ball({0.0, 0.0}, {1.0, 0.0}), ball({2.0, 0.0}, {-1.0, 0.0}), ball({-5.0, 0.0}, {0.0, 0.0}),
                 ball({2.5, 9.0}, {0.0, -1.0})};
  const Result result = watched_run(scene, {.until = 100.0});
  ASSERT_EQ(result.log.size(), 1u) << "at (1, 0), at rest: ball 2 is not reached, ball 3 passes beside it";
  EXPECT_EQ(result.balls.size(), 3u);
  EXPECT_EQ(result.balls[0].position, (std::vector<Number>{1.0, 0.0}));
  scene.balls[1].position = {0.5, 0.0};
  EXPECT_EQ(refusals(scene).size(), 1u) << "a start that overlaps is refused, not merged";
}

}  // namespace
}  // namespace carom
