// Balls on a line: a train of plastic hits, the permutation of velocities, Newton's cradle.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <numeric>
#include <thread>

#include "sim/scenes.hpp"

namespace carom {
namespace {

using namespace testing;

// Three equal points, the first hits two at rest, restitution r: ceil(pi / phi) - 1 hits, cos phi = (1 + r) / (4 sqrt r),
// for r > 7 - 4 sqrt 3 = 0.0718, and infinitely many below [McNamaraYoung1992].
Scene three_balls(double r, double gap1, double gap2, double drift, double radius = 0.0) {
  Scene scene = open_space(1);
  scene.collision.restitution = r;
  const double sigma = 2 * radius;
  scene.balls = {ball({0.0}, {1.0 + drift}, radius), ball({sigma + gap1}, {drift}, radius),
                 ball({2 * sigma + gap1 + gap2}, {drift}, radius)};
  return scene;
}

struct Train {
  double r;
  std::size_t count;
};

TEST(ThreeBalls, count_follows_the_restitution_whatever_the_gaps) {
  Dice dice(3);
  for (const Train& t : {Train{1.0, 2}, Train{0.9, 3}, Train{0.5, 3}, Train{0.2, 3}, Train{0.17, 4}, Train{0.12, 4},
                         Train{0.1, 6}, Train{0.09, 7}, Train{0.08, 10}})
    for (int i = 0; i < 20; ++i) {
      const double gap1 = i == 0 ? 1.0 : dice.between(0.01, 5.0), gap2 = i == 0 ? 1.0 : dice.between(0.01, 5.0);
      // The relative speeds fall to 1e-6 at the most: a frame that moves with a few units changes no count.
      const double drift = i % 4 == 0 ? 0.0 : i % 4 == 1 ? -1.0 / 3.0 : i % 4 == 2 ? 0.7 : -2.3;
      const Result result = run(three_balls(t.r, gap1, gap2, drift, i % 2 == 0 ? 0.0 : 0.35), 1000);
      EXPECT_EQ(result.stop, Stop::no_events_left) << "r " << t.r << " case " << i;
      EXPECT_EQ(result.log.size(), t.count) << "r " << t.r << " gaps " << gap1 << ' ' << gap2 << " drift " << drift;
      EXPECT_LE(result.summary.energy.relative_error, 1e-14);
    }
}

TEST(ThreeBalls, final_velocities) {
  const auto finals = [](double r) {
    const Result result = run(three_balls(r, 1.0, 0.3, 0.0), 1000);
    return std::array<double, 3>{result.balls[0].velocity[0], result.balls[1].velocity[0], result.balls[2].velocity[0]};
  };
  const auto expect = [](const std::array<double, 3>& v, const std::array<double, 3>& w) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(v[i], w[i], 1e-14);
  };
  expect(finals(0.9), {0.047625, 0.049875, 0.9025});
  expect(finals(0.5), {0.203125, 0.234375, 0.5625});
  expect(finals(0.2), {0.304, 0.336, 0.36});
  expect(finals(1.0), {0.0, 0.0, 1.0});
}

// Below the threshold the run ends by itself, in the frame of the centre of mass, and names the balls.
TEST(ThreeBalls, collapse_below_the_threshold_is_recognised) {
  for (const double r : {0.07, 0.06, 0.05, 0.02, 0.01, 1e-3})
    for (const double radius : {0.0, 0.4}) {
      const Result result = run(three_balls(r, 1.0, 1.0, -1.0 / 3.0, radius), 1'000'000);
      EXPECT_EQ(result.stop, Stop::collapse) << "r " << r << ", " << result.log.size() << " collisions";
      if (result.stop != Stop::collapse) continue;
      ASSERT_TRUE(result.summary.stopped.has_value());
      EXPECT_EQ(result.summary.stopped->balls, (std::vector<std::uint32_t>{0, 1, 2}));
      EXPECT_LE(result.log.size(), 20000u);
      EXPECT_EQ(result.summary.exactness.clamped, 0);
    }
}

// In any frame and for any restitution the run ends.
TEST(ThreeBalls, no_restitution_hangs) {
  Dice dice(9);
  for (int i = 0; i < 300; ++i) {
    const double r = i < 20 ? 0.0 : dice.between(0.0, 0.1);
    const Result result =
        run(three_balls(r, dice.between(0.01, 2.0), dice.between(0.01, 2.0), dice.between(-3.0, 3.0), 0.0), 200'000);
    EXPECT_TRUE(result.stop == Stop::collapse || result.stop == Stop::no_events_left) << "r " << r;
    EXPECT_LE(result.summary.energy.relative_error, 1e-13) << "r " << r;
  }
}

// Equal elastic rods: velocities permute; ball i ends where the i-th of the sorted lines x_i - 2 R i + v_i t is; as many
// collisions as inversions of the velocity order, at most N (N - 1) / 2.
struct Permutation {
  std::vector<double> x, v;
  double radius = 0.0;
};

Permutation random_line(int n, double radius, std::uint64_t seed) {
  Dice dice(seed);
  Permutation p;
  p.radius = radius;
  double x = 0.0;
  for (int i = 0; i < n; ++i) {
    x += 2 * radius + dice.between(0.01, 1.0);
    p.x.push_back(x);
    p.v.push_back(dice.between(-1.0, 1.0));
  }
  return p;
}

Scene scene_of(const Permutation& p) {
  Scene scene = open_space(1);
  for (std::size_t i = 0; i < p.x.size(); ++i) scene.balls.push_back(ball({p.x[i]}, {p.v[i]}, p.radius));
  return scene;
}

TEST(EqualRods, velocities_permute_and_positions_sort) {
  for (const double radius : {0.0, 0.3}) {
    const int n = 60;
    const Permutation p = random_line(n, radius, 21);
    std::int64_t inversions = 0;
    for (int i = 0; i < n; ++i)
      for (int j = i + 1; j < n; ++j) inversions += p.v[i] > p.v[j];
    for (const double t : {0.5, 3.0, 50.0}) {
      const Result result = run_until(scene_of(p), t);
      std::vector<double> lines;
      for (int i = 0; i < n; ++i) lines.push_back(p.x[i] - 2 * radius * i + p.v[i] * t);
      std::sort(lines.begin(), lines.end());
      for (int i = 0; i < n; ++i)
        EXPECT_NEAR(result.balls[i].position[0], lines[i] + 2 * radius * i, 1e-12 * std::max(t, 10.0))
            << "ball " << i << " t " << t;
    }
    Simulation simulation(scene_of(p));
    // Ten seconds at the most, should the engine look for the collision that does not come.
    std::atomic<bool> enough{false};
    std::jthread clock([&](const std::stop_token& done) {
      for (int i = 0; i < 100 && !done.stop_requested(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(100));
      enough = true;
    });
    EXPECT_EQ(simulation.advance(std::nullopt, std::nullopt, {}, &enough), Stop::no_events_left) << "everybody flies away";
    EXPECT_EQ(simulation.counts().collisions(), inversions);
    std::vector<double> sorted = p.v, final;
    std::sort(sorted.begin(), sorted.end());
    for (const BallState& b : simulation.balls()) final.push_back(b.velocity[0]);
    EXPECT_EQ(final, sorted) << "bit for bit: equal masses exchange velocities";
  }
}

// Equal rods in a hard box: the same sorting with reflected images; here only what is exact: the speeds stay a permutation.
TEST(EqualRods, in_a_box_the_speeds_are_a_permutation_for_ever) {
  Permutation p = random_line(9, 0.25, 5);
  Scene scene = scene_of(p);
  scene.space.kind = SpaceKind::box;
  scene.space.lower = {0.0};
  scene.space.upper = {p.x.back() + 0.5};
  const Result result = run(scene, 20000);
  std::vector<double> before, after;
  for (const double v : p.v) before.push_back(std::abs(v));
  for (const BallState& b : result.balls) after.push_back(std::abs(b.velocity[0]));
  std::sort(before.begin(), before.end());
  std::sort(after.begin(), after.end());
  EXPECT_EQ(after, before);
  EXPECT_LE(result.summary.energy.relative_error, 1e-16);
}

// On a ring of length 10 a moving rod meets the resting one after 6, then they take turns, one way round, every 10 - 2:
// whichever of its images the scene names, and however often they have gone round.
TEST(Ring, two_rods_take_turns) {
  for (const double x : {2.0, 12.0, -8.0, 32.0, -1008.0})
    for (const bool swapped : {false, true}) {
      Scene scene = open_space(1);
      scene.space.kind = SpaceKind::periodic;
      scene.space.lower = {0.0};
      scene.space.upper = {10.0};
      scene.balls = {ball({5.0}, {1.0}), ball({x}, {0.0})};
      if (swapped) std::swap(scene.balls[0], scene.balls[1]);
      const Result result = run_until(scene, 500.0);
      ASSERT_EQ(result.log.size(), 62u) << "rod at " << x;
      for (std::size_t i = 0; i < result.log.size(); ++i)
        EXPECT_EQ(result.log[i].time, 6.0 + 8.0 * double(i)) << "rod at " << x;
      EXPECT_EQ(result.summary.exactness.max_gap_error, 0.0);
    }
}

// Many rods on a ring: nobody jumps over anybody, the velocities stay a permutation, and nothing overlaps.
TEST(Ring, keeps_the_order_and_the_speeds) {
  for (const double radius : {0.3, 0.0}) {
    const Permutation p = random_line(11, radius, 8);
    Scene scene = scene_of(p);
    scene.space.kind = SpaceKind::periodic;
    scene.space.lower = {0.0};
    scene.space.upper = {p.x.back() + 0.7};
    for (std::size_t i = 0; i < scene.balls.size(); i += 3)
      scene.balls[i].position[0] = scene.balls[i].position[0] + 3 * scene.space.upper[0];
    const Result result = run(scene, 20000);
    EXPECT_LE(result.summary.exactness.max_gap_error, 1e-13);
    EXPECT_EQ(result.summary.exactness.clamped, 0);
    for (const Collision& c : result.log) {
      const std::uint32_t apart = c.partner.number - c.ball.number;
      ASSERT_TRUE(apart == 1 || apart == 10) << "neighbours on the ring";
    }
    std::vector<double> before = p.v, after;
    for (const BallState& b : result.balls) after.push_back(b.velocity[0]);
    std::sort(before.begin(), before.end());
    std::sort(after.begin(), after.end());
    EXPECT_EQ(after, before);
  }
}

// k balls in, k balls out.
TEST(Cradle, as_many_leave_as_came) {
  for (const double gap : {0.0, 1e-9, 1e-3})
    for (int in = 1; in <= 4; ++in) {
      const int n = 7;
      Scene scene = open_space(1);
      double x = 0.0;
      for (int i = 0; i < n; ++i) {
        scene.balls.push_back(ball({x}, {i < in ? 1.0 : 0.0}));
        x += 1.0 + (i == in - 1 ? 2.0 : gap);
      }
      const Result result = run(scene, 1000);
      EXPECT_EQ(result.stop, Stop::no_events_left);
      EXPECT_EQ(result.log.size(), std::size_t(in * (n - in))) << "gap " << gap << ", " << in << " in";
      for (int i = 0; i < n; ++i)
        EXPECT_EQ(result.balls[i].velocity[0], i >= n - in ? 1.0 : 0.0) << "gap " << gap << ", " << in << " in";
      EXPECT_EQ(result.summary.exactness.clamped, 0);
    }
}

// The same with spheres in 2-D and 3-D, in contact by their coordinates (which are not all exact).
TEST(Cradle, in_two_and_three_dimensions) {
  for (int d = 2; d <= 3; ++d)
    for (const double radius : {0.5, 0.1, 1.0 / 3.0}) {
      Scene scene = open_space(d);
      Coordinates v(std::size_t(d), 0.0);
      for (int i = 0; i < 6; ++i) {
        Coordinates x(std::size_t(d), 0.0);
        x[0] = i == 0 ? -2.0 : 2 * radius * (i - 1);
        v[0] = i == 0 ? 1.0 : 0.0;
        scene.balls.push_back(ball(x, v, radius));
      }
      const Result result = run(scene, 1000);
      EXPECT_EQ(result.stop, Stop::no_events_left);
      EXPECT_EQ(result.log.size(), 5u) << d << "-D, radius " << radius;
      for (int i = 0; i < 6; ++i) EXPECT_NEAR(result.balls[i].velocity[0], i == 5 ? 1.0 : 0.0, 1e-15);
      EXPECT_EQ(result.summary.exactness.clamped, 0);
    }
}

}  // namespace
}  // namespace carom
