// Rest on flat walls: when it begins, what it does to the energy, how it goes on and how it ends.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/scenes.hpp"

namespace carom {
namespace {

using namespace testing;
using ::testing::AnyOf;
using ::testing::HasSubstr;

Scene resting(int dimension, Coordinates acceleration, double e) {
  Scene scene = open_space(dimension);
  scene.motion.acceleration = std::move(acceleration);
  scene.collision.restitution = e;
  scene.collision.regularise = Regularise::rest;
  return scene;
}

WallSpec segment(Coordinates from, Coordinates to) {
  WallSpec w;
  w.kind = WallKind::segment;
  w.from = std::move(from);
  w.to = std::move(to);
  return w;
}

// From the height h: T = sqrt(2 h / g) (1 + e) / (1 - e), path h (1 + e^2) / (1 - e^2).
TEST(Rest, begins_where_the_bounces_accumulate) {
  for (const int d : {1, 2, 3}) {
    const auto last = static_cast<std::size_t>(d - 1);
    Coordinates a(last + 1, 0.0), n(last + 1, 0.0), x(last + 1, 0.0);
    a[last] = -9.81;
    n[last] = 1.0;
    x[last] = 1.5;
    Scene scene = resting(d, a, 0.9);
    scene.walls = {plane(Coordinates(last + 1, 0.0), n)};
    scene.balls = {ball(x, {})};
    Simulation simulation(scene);
    double path = 1.0;
    const auto rise = [&](const Collision& c) {
      path += c.ball.velocity_after[last] * c.ball.velocity_after[last] / 9.81;
    };
    const double T = 8.578949178729;
    EXPECT_EQ(simulation.advance(Number(T - 1e-10), std::nullopt, rise), Stop::until);
    EXPECT_EQ(simulation.counts().other, 0);
    EXPECT_EQ(simulation.advance(Number(T + 1e-10), std::nullopt, rise), Stop::no_events_left);
    EXPECT_EQ(simulation.counts().other, 1);
    EXPECT_NEAR(path, 9.526315789474, 1e-10);
    EXPECT_EQ(simulation.advance(Number(1000.0)), Stop::no_events_left);
    EXPECT_EQ(simulation.ball(0).position[last], 0.5);
    EXPECT_EQ(simulation.ball(0).velocity[last], 0.0);
    const Summary s = simulation.summary();
    EXPECT_EQ(s.exactness.summed_bounces, 1);
    EXPECT_EQ(s.exactness.clamped, 0);
    EXPECT_NEAR(s.energy.dissipated, 9.81, 1e-13);
    EXPECT_LE(s.energy.relative_error, 1e-15);
  }
}

TEST(Rest, begins_at_the_first_touch_if_plastic_and_at_once_from_the_floor) {
  Scene scene = resting(2, {0.0, -1.0}, 0.0);
  scene.walls = {plane({0.0, 0.0}, {0.0, 1.0})};
  scene.balls = {ball({0.0, 1.0}, {0.25, 0.0}), ball({5.0, 0.5}, {0.0, 0.0})};
  const Result result = run_until(scene, 10.0);
  EXPECT_EQ(result.log.size(), 1u) << "lying on the floor is no collision";
  EXPECT_EQ(result.summary.events.other, 2);
  EXPECT_EQ(result.balls[0].position, (std::vector<Number>{2.5, 0.5}));
  EXPECT_EQ(result.balls[0].velocity, (std::vector<Number>{0.25, 0.0}));
  EXPECT_LE(result.summary.energy.relative_error, 1e-16);
}

// Any restitution below 1 comes to rest, close to 1 too, where the clock runs out of digits first.
TEST(Rest, begins_for_every_restitution) {
  for (const double e : {0.01, 0.3, 0.7, 0.97, 0.999, 0.9999}) {
    Scene scene = resting(1, {-1.0}, e);
    scene.walls = {plane({0.0}, {1.0})};
    scene.balls = {ball({1.0}, {0.0})};
    const Result result = run(scene, 1'000'000);
    EXPECT_EQ(result.stop, Stop::no_events_left) << e;
    EXPECT_EQ(result.summary.events.other, 1) << e;
    EXPECT_NEAR(result.summary.time, (1 + e) / (1 - e), 1e-10 / (1 - e)) << e;  // sqrt(2 h / g) = 1
    EXPECT_LE(result.summary.energy.relative_error, 1e-14) << e;
  }
}

// On a slope of 3 : 4 a ball slides with 3/5 g once it rests.
TEST(Rest, slides_down_a_slope) {
  Scene scene = resting(2, {0.0, -1.0}, 0.5);
  scene.walls = {plane({0.0, 0.0}, {0.6, 0.8})};
  scene.balls = {ball({0.3, 0.4}, {0.0, 0.0}), ball({6.3, -3.6}, {0.6, 0.8})};
  Simulation simulation(scene);
  simulation.advance(Number(20.0));
  const BallState at_rest = simulation.ball(0), bounced = simulation.ball(1);
  EXPECT_NEAR(at_rest.velocity[0], 20 * 0.6 * 0.8, 1e-13);
  EXPECT_NEAR(at_rest.velocity[1], -20 * 0.6 * 0.6, 1e-13);
  for (const BallState& b : {at_rest, bounced})
    EXPECT_NEAR(0.6 * b.position[0] + 0.8 * b.position[1], 0.5, 1e-13) << "it keeps to the slope";
  EXPECT_EQ(simulation.counts().other, 2);
  EXPECT_LE(simulation.summary().energy.relative_error, 1e-15);
}

// A lift that rises with 1/2 carries a ball of weight 2: it does work of 1 a unit of time.
// An elastic ball that bounces too low to be seen, 10^16 times in a unit of time, rests; and what it does along the floor is
// rounded once, not with each bounce.
TEST(Rest, ends_elastic_bounces_that_nobody_could_see) {
  Scene scene = resting(2, {0.0, -1.0}, 1.0);
  scene.walls = {plane({0.0, 0.0}, {0.0, 1.0})};
  scene.balls = {ball({4.9, 0.5}, {1.0, 2e-16})};
  Simulation simulation(scene);
  EXPECT_EQ(simulation.advance(Number(100.0), 1000), Stop::no_events_left);
  EXPECT_EQ(simulation.ball(0).position[0], 104.9);
  EXPECT_EQ(simulation.ball(0).position[1], 0.5);
  const Summary s = simulation.summary();
  EXPECT_EQ(s.events.ball_wall, 1);
  EXPECT_LE(s.energy.relative_error, 1e-15);
  // What can be seen goes on for ever.
  scene.balls[0].velocity[1] = 1e-4;
  EXPECT_EQ(Simulation(scene).advance(Number(100.0), 1000), Stop::events);
}

TEST(Rest, on_a_moving_floor_is_carried) {
  Scene scene = resting(2, {0.0, -2.0}, 0.0);
  scene.walls = {plane({0.0, 0.0}, {0.0, 1.0})};
  scene.walls[0].velocity = {0.0, 0.5};
  scene.balls = {ball({0.0, 0.5}, {1.0, 0.5})};
  Simulation simulation(scene);
  for (const double t : {1.0, 4.0, 10.0}) {
    simulation.advance(Number(t));
    EXPECT_EQ(simulation.ball(0).position, (std::vector<Number>{t, 0.5 + t / 2}));
    EXPECT_EQ(simulation.summary().energy.injected, t);
    EXPECT_EQ(simulation.summary().energy.relative_error, 0.0);
  }
}

// A hit along the floor leaves a ball on it; one from above drives it into the floor, and both fly.
TEST(Rest, ends_with_an_impact) {
  Scene scene = resting(2, {0.0, -1.0}, 0.5);
  scene.walls = {plane({0.0, 0.0}, {0.0, 1.0})};
  scene.balls = {ball({0.0, 0.5}, {0.0, 0.0}), ball({-3.0, 0.5}, {1.0, 0.0})};
  const Result along = run_until(scene, 100.0);
  EXPECT_EQ(along.log.size(), 1u);
  EXPECT_EQ(along.balls[0].velocity, (std::vector<Number>{0.75, 0.0})) << "(1 + e) / 2 of the speed";
  EXPECT_EQ(along.balls[1].velocity, (std::vector<Number>{0.25, 0.0}));

  scene.balls = {ball({0.0, 0.5}, {0.0, 0.0}), ball({0.3, 4.0}, {0.0, 0.0})};
  const Result result = run_until(scene, 100.0);
  EXPECT_GT(result.balls[1].velocity[0], 0.1);
  for (const BallState& b : result.balls) EXPECT_EQ(b.position[1], 0.5) << "all lie on the floor in the end";
  EXPECT_EQ(result.stop, Stop::no_events_left);
  EXPECT_GE(result.summary.exactness.summed_bounces, 2);
  EXPECT_LE(result.summary.energy.relative_error, 1e-15);
  EXPECT_EQ(result.summary.exactness.clamped, 0);
}

// A point slides off a table of height 2 with speed 1/2 at t = 5: y = 2 - (t - 5)^2 / 2 from there.
TEST(Rest, ends_where_the_wall_ends) {
  Scene scene = resting(2, {0.0, -1.0}, 0.5);
  scene.collision.restitution = 0.0;
  scene.walls = {segment({-1.0, 2.0}, {2.0, 2.0})};
  scene.balls = {ball({-0.5, 2.5}, {0.5, 0.0}, 0.0)};
  Simulation simulation(scene);
  EXPECT_EQ(simulation.advance(Number(4.9375)), Stop::until);
  EXPECT_EQ(simulation.counts().other, 1);
  EXPECT_EQ(simulation.advance(Number(5.0)), Stop::no_events_left);
  EXPECT_EQ(simulation.counts().other, 2);
  EXPECT_EQ(simulation.counts().collisions(), 1);
  simulation.advance(Number(8.0));
  EXPECT_EQ(simulation.ball(0).position, (std::vector<Number>{3.5, -2.5}));
  EXPECT_LE(simulation.summary().energy.relative_error, 1e-16);
}

// A ball leaves the end of the table at v^2 > g R without touching it; a slower one would turn about it, which is named.
TEST(Rest, at_the_end_of_a_wall_a_fast_ball_flies_off) {
  for (const bool to_the_left : {true, false}) {
    Scene scene = resting(2, {0.0, -1.0}, 0.5);
    scene.walls = {segment({-4.0, 2.0}, {4.0, 2.0})};
    scene.balls = {ball({0.0, 2.5}, {to_the_left ? -1.0 : 1.0, 0.0})};
    const Result fast = run_until(scene, 6.0);
    EXPECT_EQ(fast.stop, Stop::no_events_left);
    EXPECT_EQ(fast.log.size(), 0u);
    EXPECT_EQ(fast.balls[0].position, (std::vector<Number>{to_the_left ? -6.0 : 6.0, 0.5}));
    scene.balls[0].velocity = {0.25, 0.0};
    const Result slow = run_until(scene, 100.0);
    if (slow.stop == Stop::collapse) {
      EXPECT_FALSE(slow.summary.stopped->reason.empty());
      EXPECT_NEAR(slow.summary.time, 16.0, 1.0);
    }
    EXPECT_LE(slow.summary.energy.relative_error, 1e-14);
  }
}

// At the moment at which it slides off the end of the table a disk hits the side of the box, which sends it back.
TEST(Rest, goes_on_if_a_hit_at_the_end_of_the_wall_leads_back) {
  Scene scene = resting(2, {0.0, -0.25}, 1.0);
  scene.space.kind = SpaceKind::box;
  scene.space.lower = {0.0, 0.0};
  scene.space.upper = {8.0, 8.0};
  scene.walls = {segment({0.5, 2.0}, {6.5, 2.0})};
  scene.balls = {ball({1.5, 2.5}, {-1.0, 0.0})};
  const Result result = run_until(scene, 4.0);
  EXPECT_EQ(result.log.size(), 1u);
  EXPECT_EQ(result.balls[0].position, (std::vector<Number>{3.5, 2.5}));
  EXPECT_EQ(result.balls[0].velocity, (std::vector<Number>{1.0, 0.0}));
}

// Thrown up at 2 with g = 1, a disk or a point hits the table 1/2 above it at sqrt(3) and leaves it at e sqrt(3).
TEST(Rest, does_not_begin_under_a_wall) {
  for (const double radius : {0.5, 0.0})
    for (const double e : {1.0, 0.5}) {
      Scene scene = resting(2, {0.0, -1.0}, e);
      scene.walls = {segment({-1.0, 2.0}, {1.0, 2.0})};
      scene.balls = {ball({0.0, 1.5 - radius}, {0.0, 2.0}, radius)};
      const Result result = run_until(scene, 2.0);
      ASSERT_EQ(result.log.size(), 1u);
      EXPECT_EQ(result.summary.events.other, 0);
      const double flight = 2.0 - result.log[0].time, w = e * std::sqrt(3.0);
      EXPECT_NEAR(flight, std::sqrt(3.0), 1e-15);
      EXPECT_NEAR(result.balls[0].position[1], 2.0 - radius - w * flight - flight * flight / 2, 1e-14);
      EXPECT_LE(result.summary.energy.relative_error, 1e-15);
    }
}

// Under the overhang of a polygon a disk that weighs upwards bounces off both the ceiling and the edge below it.
TEST(Rest, does_not_begin_on_an_edge_that_a_ball_falls_away_from) {
  Scene scene = resting(2, {0.0, 0.25}, 0.9);
  scene.space.kind = SpaceKind::box;
  scene.space.lower = {0.0, 0.0};
  scene.space.upper = {8.0, 8.0};
  WallSpec triangle;
  triangle.kind = WallKind::polygon;
  triangle.vertices = {{1.5, 6.5}, {3.5, 6.5}, {1.5, 8.5}};
  scene.walls = {triangle};
  scene.balls = {ball({3.75, 7.25}, {-0.625, -0.75})};
  Simulation simulation(scene);
  std::int64_t hits_of_edge = 0;
  const auto count = [&](const Collision& c) { hits_of_edge += c.partner.number == 0; };
  for (int k = 1; k <= 40; ++k) {
    simulation.advance(Number(0.25 * k), std::nullopt, count);
    ASSERT_EQ(simulation.audit(AuditBy::every_pair).overlaps, 0) << k;
  }
  EXPECT_GT(hits_of_edge, 0);
}

// Not held: in the corner of two walls, on another ball, in a circle. Each is a collapse that is named.
TEST(Rest, elsewhere_is_named) {
  const auto reason = [](const Scene& scene) {
    const Result result = run(scene, 1'000'000);
    EXPECT_EQ(result.stop, Stop::collapse);
    EXPECT_LE(result.summary.energy.relative_error, 1e-14);
    return result.summary.stopped ? result.summary.stopped->reason : "";
  };
  Scene wedge = resting(2, {0.0, -1.0}, 0.5);
  wedge.walls = {plane({0.0, 0.0}, {1.0, 1.0}), plane({0.0, 0.0}, {-1.0, 2.0})};
  wedge.balls = {ball({0.1, 3.0}, {0.0, 0.0})};
  EXPECT_THAT(reason(wedge), HasSubstr("in a corner"));

  Scene corner = resting(2, {0.5, -1.0}, 0.5);
  corner.walls = {plane({0.0, 0.0}, {0.0, 1.0}), plane({3.0, 0.0}, {-1.0, 0.0})};
  corner.balls = {ball({0.5, 0.5}, {0.0, 0.0})};
  EXPECT_THAT(reason(corner), HasSubstr("in a corner"));

  Scene stack = resting(2, {0.0, -1.0}, 0.5);
  stack.walls = {plane({0.0, 0.0}, {0.0, 1.0})};
  stack.balls = {ball({0.0, 0.5}, {0.0, 0.0}), ball({0.0, 2.0}, {0.0, 0.0})};
  EXPECT_THAT(reason(stack), HasSubstr("another ball"));

  Scene bowl = resting(2, {0.0, -1.0}, 0.5);
  bowl.walls = {circle({0.0, 0.0}, 2.0, WallSide::inside)};
  bowl.balls = {ball({0.0, 0.0}, {0.0, 0.0})};
  EXPECT_THAT(reason(bowl), HasSubstr("curved wall"));
}

Scene settling_gas(double contact_time, double e = 0.9) {
  Scene scene = mixed_box(2, 50, 16.0, 17, 0.6, 2.0);
  scene.motion.acceleration = {0.0, -1.0};
  scene.collision.restitution = e;
  scene.collision.regularise = Regularise::rest;
  scene.collision.contact_time = contact_time;
  return scene;
}

// Fifty disks settle: the run reaches its end or says why it does not, and the books balance all the way.
TEST(Rest, of_a_gas_never_hangs) {
  for (const double contact_time : {0.0, 1e-2, 1e-4}) {
    Scene scene = settling_gas(contact_time);
    Simulation simulation(scene);
    const Stop stop = simulation.advance(Number(30.0), 3'000'000);
    EXPECT_TRUE(stop == Stop::until || stop == Stop::collapse) << int(stop);
    const Summary s = simulation.summary();
    if (stop == Stop::collapse) {
      EXPECT_THAT(s.stopped->reason, AnyOf(HasSubstr("Remedies"), HasSubstr("without room to move")));
    }
    EXPECT_LE(s.energy.relative_error, 1e-12);
    EXPECT_EQ(s.exactness.clamped, 0);
    EXPECT_EQ(simulation.audit(AuditBy::every_pair).overlaps, 0);
  }
}

/// Few balls on a wide floor, a slope of a polygon and a shelf: rest, sliding, hits and ends of walls, for long.
Scene floor_show() {
  Scene scene = resting(2, {0.0, -1.0}, 0.6);
  scene.space.kind = SpaceKind::box;
  scene.space.lower = {0.0, 0.0};
  scene.space.upper = {40.0, 12.0};
  scene.space.restitution = 0.6;
  scene.collision.contact_time = 1e-3;
  scene.walls = {segment({18.0, 5.0}, {24.0, 4.0})};
  Dice dice(3);
  for (int i = 0; i < 30; ++i) {
    const double vx = dice.between(-2.0, 2.0), vy = dice.between(-1.0, 1.0), r = i % 3 == 0 ? 0.25 : 0.4;
    scene.balls.push_back(ball({1.0 + 1.3 * i, 7.0 + 2.0 * (i % 2)}, {vx, vy}, r));
  }
  return scene;
}

TEST(Rest, has_the_same_log_for_every_search_and_queue) {
  for (const Scene& scene : {floor_show(), settling_gas(1e-2, 0.3)}) {
    std::vector<std::vector<Collision>> logs;
    std::vector<std::int64_t> rests;
    const auto add = [&](Simulation simulation) {
      auto& log = logs.emplace_back();
      simulation.advance(Number(12.0), 20'000, [&](const Collision& c) { log.push_back(c); });
      rests.push_back(simulation.counts().other);
      EXPECT_EQ(simulation.summary().exactness.clamped, 0);
    };
    add(Simulation(scene));
    add(Simulation::reference(scene));
    for (const SearchKind kind : {SearchKind::all_pairs, SearchKind::cells}) {
      Scene other = scene;
      other.engine.search = kind;
      add(Simulation(other));
    }
    EXPECT_GT(logs[0].size(), 500u);
    EXPECT_GT(rests[0], 0);
    for (std::size_t k = 1; k < logs.size(); ++k) {
      EXPECT_EQ(difference(logs[0], logs[k]), "") << k;
      EXPECT_EQ(rests[k], rests[0]) << k;
    }
  }
}

TEST(Rest, goes_on_from_a_checkpoint_bit_for_bit) {
  const Scene scene = floor_show();
  Simulation whole(scene);
  std::vector<Collision> log;
  const Stop end = whole.advance(Number(20.0), std::nullopt, [&](const Collision& c) { log.push_back(c); });
  EXPECT_GT(whole.time(), 5.0);
  EXPECT_GT(whole.counts().other, 10);
  std::vector<Collision> parts;
  std::string state;
  for (int part = 1; part <= 40; ++part) {
    Simulation simulation(scene);
    if (!state.empty()) simulation.restore(state);
    const Stop stop =
        simulation.advance(Number(0.5 * part), std::nullopt, [&](const Collision& c) { parts.push_back(c); });
    state = simulation.state();
    if (stop == Stop::until && part < 40) continue;
    EXPECT_EQ(stop, end);
    EXPECT_TRUE(same_bits(simulation.summary().energy.final, whole.summary().energy.final));
    EXPECT_TRUE(same_bits(simulation.summary().energy.dissipated, whole.summary().energy.dissipated));
    EXPECT_EQ(simulation.counts().other, whole.counts().other);
    break;
  }
  EXPECT_EQ(difference(log, parts), "");
}

}  // namespace
}  // namespace carom
