// All contacts of one moment at once (collision.simultaneous = "symmetric").

#include <gtest/gtest.h>

#include "sim/scenes.hpp"

namespace carom {
namespace {

using namespace testing;

Scene symmetric(Scene scene) {
  scene.collision.simultaneous = Simultaneous::symmetric;
  return scene;
}

std::vector<double> speeds(const std::vector<BallState>& balls) {
  std::vector<double> v;
  for (const BallState& b : balls) v.push_back(b.velocity[0]);
  return v;
}

/// Five equal balls in contact on a line; the first k come in together, touching too.
Scene cradle(int k, double e = 1.0) {
  Scene scene = open_space(1);
  scene.collision.restitution = e;
  for (int i = 0; i < 5; ++i) {
    const bool moves = i < k;
    scene.balls.push_back(ball({moves ? i - 3.0 : i * 1.0}, {moves ? 1.0 : 0.0}));
  }
  return symmetric(scene);
}

// k in, k out, without gaps: the reflections run through the row.
TEST(Symmetric, cradle_sends_out_as_many_as_come_in) {
  for (int k = 1; k <= 4; ++k) {
    const Result r = run_until(cradle(k), 5.0);
    std::vector<double> expected(5, 0.0);
    for (int i = 5 - k; i < 5; ++i) expected[static_cast<std::size_t>(i)] = 1.0;
    EXPECT_EQ(speeds(r.balls), expected) << k << " balls";
    EXPECT_EQ(r.summary.energy.relative_error.value, 0.0);
  }
}

// e = 0: one body from then on, in one event: all have the velocity 1/5.
TEST(Symmetric, plastic_cradle_goes_on_together) {
  const Result r = run_until(cradle(1, 0.0), 5.0);
  for (const double v : speeds(r.balls)) EXPECT_NEAR(v, 0.2, 1e-16);
  EXPECT_NEAR(r.summary.energy.dissipated, 0.5 - 0.1, 1e-15);
  EXPECT_LE(r.summary.energy.relative_error, 1e-15);
  EXPECT_EQ(r.stop, Stop::no_events_left);
}

// A rack hit along its axis: balls that mirror each other leave mirrored, bit for bit; in pairwise order they do not.
TEST(Symmetric, rack_breaks_symmetrically) {
  for (const double e : {1.0, 0.9}) {
    Scene scene = symmetric(rack_and_cue());
    scene.collision.restitution = e;
    Simulation simulation(scene);
    simulation.advance(Number(1.5));  // the cue ball is there at 5/3 from 6 - 1
    simulation.advance(Number(1.8));
    EXPECT_GT(simulation.counts().ball_ball, 4);
    const std::vector<BallState> balls = simulation.balls();
    int mirrored = 0;
    for (const BallState& a : balls)
      for (const BallState& b : balls)
        if (a.position[0] == b.position[0] && a.position[1] == -b.position[1]) {
          ++mirrored;
          EXPECT_TRUE(same_bits(a.velocity[0], b.velocity[0])) << e << ": balls " << a.index << ", " << b.index;
          EXPECT_EQ(a.velocity[1].value, -b.velocity[1].value) << e << ": balls " << a.index << ", " << b.index;
        }
    EXPECT_EQ(mirrored, 16) << "every ball has its mirror image";
    EXPECT_LE(simulation.summary().energy.relative_error, 1e-15);
    EXPECT_EQ(simulation.audit(AuditBy::every_pair).overlaps, 0);
  }
}

// Hit from both sides at one instant, a ball stays where it is; one after the other it would not.
TEST(Symmetric, equal_times_are_one_event) {
  Scene scene = open_space(2);
  scene.balls = {ball({0, 0}, {0, 0}, 0.5, 3), ball({-3, 0}, {1, 0}), ball({3, 0}, {-1, 0})};
  const Result r = run_until(symmetric(scene), 4.0);
  EXPECT_EQ(r.log.size(), 2u);
  EXPECT_EQ(r.balls[0].velocity[0].value, 0.0);
  EXPECT_EQ(r.balls[1].velocity[0].value, -1.0);
  EXPECT_EQ(r.balls[2].velocity[0].value, 1.0);
  EXPECT_EQ(r.summary.events.ties, 1);
  const Result one_by_one = run_until(scene, 4.0);
  EXPECT_NE(one_by_one.balls[1].velocity[0].value, -one_by_one.balls[2].velocity[0].value);
}

// Into the corner of a box: both faces at once turn the velocity round.
TEST(Symmetric, corner) {
  Scene scene = box({0, 0}, {10, 10});
  scene.balls = {ball({3, 3}, {-1, -1})};
  const Result r = run(symmetric(scene), 2);
  ASSERT_EQ(r.log.size(), 2u);
  EXPECT_EQ(r.log[0].offset, r.log[1].offset);
  EXPECT_EQ(r.balls[0].velocity[0].value, 1.0);
  EXPECT_EQ(r.balls[0].velocity[1].value, 1.0);
}

// Where nothing is simultaneous both rules are one: the same log, bit for bit.
TEST(Symmetric, without_ties_the_log_is_the_sequential_one) {
  for (const int dimension : {1, 2, 3}) {
    Scene scene = dimension == 1 ? rods(8, 5) : mixed_box(dimension, 12, 8.0, 5);
    for (const double e : {1.0, 0.95}) {
      scene.collision.restitution = e;
      const Result sequential = run(scene, 500);
      EXPECT_EQ(sequential.summary.events.ties, 0);
      EXPECT_EQ(difference(sequential.log, run(symmetric(scene), 500).log), "") << dimension << "-D";
    }
  }
}

// The graph of contacts is a function of the state: another queue and search find the same, and so does a resumed run.
TEST(Symmetric, every_engine_and_a_resumed_run_agree) {
  for (Scene scene : {rack_and_cue(), rack_and_cue(0.3)}) {
    scene = symmetric(scene);
    const Result whole = run(scene, 400);
    EXPECT_GT(whole.summary.events.ties, 0);
    std::vector<Collision> again;
    Simulation::reference(scene).advance(std::nullopt, 400, [&](const Collision& c) { again.push_back(c); });
    EXPECT_EQ(difference(whole.log, again), "");
    Simulation first(scene), second(scene);
    std::vector<Collision> parts;
    const auto keep = [&](const Collision& c) { parts.push_back(c); };
    first.advance(std::nullopt, 100, keep);
    second.restore(first.state());
    second.advance(std::nullopt, 400 - first.counts().collisions(), keep);
    EXPECT_EQ(difference(whole.log, parts), "");
    EXPECT_EQ(whole.summary.exactness.clamped, 0);
  }
}

// A point that lies at rest on a vertex and is hit: the vertex has no direction to act in, and no number is lost to it.
// A light ball thrown to and fro between two that it touches: in velocities times sqrt(mass) it is reflected in the faces of
// a wedge of angle alpha, tan^2 alpha = m (m + 2 M) / M^2, some pi / (2 alpha) = 1.1e5 times from the middle, all at one
// instant. That is more than one event resolves; the next ones go on. One at a time or not, the hits are the same.
TEST(Symmetric, reflections_are_never_given_up) {
  const auto run = [](Simultaneous rule) {
    Scene scene = open_space(1);
    scene.collision.simultaneous = rule;
    scene.balls = {ball({0.0}, {0.0}), ball({1.0}, {-1.0}, 0.5, 1e-10), ball({2.0}, {0.0})};
    return run_until(scene, 1.0);
  };
  const Result all = run(Simultaneous::symmetric), singly = run(Simultaneous::sequential);
  EXPECT_EQ(all.stop, Stop::no_events_left);
  EXPECT_LT(all.log.size(), 10u);
  EXPECT_NEAR(static_cast<double>(singly.log.size()), 0.5 * 3.141592653589793 / std::sqrt(2e-10), 5.0);
  for (const Collision& c : all.log) EXPECT_EQ(c.time, 0.0);
  const std::vector<double> v = speeds(all.balls), w = speeds(singly.balls);
  EXPECT_LE(v[0], v[1]);
  EXPECT_LE(v[1], v[2]);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(v[i], w[i], 1e-11) << "of 1e-5";
  EXPECT_LE(all.summary.energy.relative_error.value, 1e-14);
  EXPECT_LE(all.summary.momentum.relative_error.value() * 1e-10, 4 * 0x1p-53 * 1e-5) << "the heavy ones have 1e-5 at the end";
}

// A fast ball between two fixed ones that it touches on opposite sides, in directions that are opposite but for the rounding
// of the places: it has no room across, loses what it has there, n (n.v) with n = (3, 4)/5, and goes on along the gap. That
// what is left closes one of the contacts by a rounding of 10^7 is nothing to go on about.
TEST(Symmetric, pinned_ball_leaves_along_the_gap) {
  Scene scene = open_space(2);
  const double v = -63100176.99256259;
  scene.balls = {ball({7.210087336090759, 0.6850354604176578}, {v, 0.0}, 0.23738780553217625, 1.03e-09),
                 ball({7.4627545972299085, 1.0219251419365236}, {}, 0.18372429636640586),
                 ball({6.974283501635791, 0.3706303478110342}, {}, 0.15561858522610322)};
  scene.balls[1].fixed = scene.balls[2].fixed = true;
  const Result r = run_until(symmetric(scene), 1e-6);
  EXPECT_EQ(r.stop, Stop::no_events_left);
  EXPECT_EQ(r.log.size(), 2u);
  EXPECT_NEAR(r.balls[0].velocity[0], 0.64 * v, 1e-14 * std::abs(v));
  EXPECT_NEAR(r.balls[0].velocity[1], -0.48 * v, 1e-14 * std::abs(v));
  EXPECT_NEAR(r.summary.energy.dissipated, 0.36 * 0.5 * 1.03e-9 * v * v, 1e-13 * 1.03e-9 * v * v);
}

TEST(Symmetric, point_at_rest_on_a_vertex) {
  Scene scene = open_space(2);
  WallSpec edge;
  edge.kind = WallKind::segment;
  edge.from = {0.0, 0.0};
  edge.to = {2.0, 0.0};
  scene.walls = {edge};
  scene.balls = {ball({0.0, 0.0}, {0.0, 0.0}, 0.0), ball({0.0, 3.0}, {0.0, -1.0}), ball({-4.0, 0.0}, {1.0, 0.0})};
  const Result r = run_until(symmetric(scene), 10.0);
  EXPECT_GT(r.log.size(), 0u);
  for (const BallState& b : r.balls) EXPECT_TRUE(std::isfinite(b.velocity[0].value) && std::isfinite(b.velocity[1].value));
  EXPECT_LE(r.summary.energy.relative_error, 1e-15);
}

// Momentum and energy over many breaks with different masses, and no overlap on the way.
TEST(Symmetric, conserves_through_many_clusters) {
  for (const double e : {1.0, 0.8}) {
    Scene scene = symmetric(rack_and_cue(0.1));
    scene.collision.restitution = e;
    Simulation simulation(scene);
    for (int k = 0; k < 40; ++k) {
      simulation.advance(Number(10.0), 25);
      EXPECT_EQ(simulation.audit(AuditBy::every_pair).overlaps, 0);
    }
    EXPECT_LE(simulation.summary().energy.relative_error, 1e-14);
    EXPECT_EQ(simulation.summary().exactness.clamped, 0);
  }
}

}  // namespace
}  // namespace carom
