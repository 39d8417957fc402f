// The same scenes in other arithmetics: what more digits give, and what double leaves.

#include <gtest/gtest.h>

#include "carom/core/error.hpp"
#include "carom/core/multi.hpp"
#include "carom/observe/horizon.hpp"
#include "carom/observe/tangent_growth.hpp"
#include "carom/scene/rounded.hpp"
#include "sim/scenes.hpp"

namespace carom {
namespace {

using namespace testing;

/// The hundred-digit challenge, problem 2 [Trefethen2002]: a photon among mirrors of radius 1/3 at the integer points.
Scene photon() {
  Scene scene = open_space(2);
  scene.space.kind = SpaceKind::periodic;
  scene.space.lower = {Number(-0.5), Number(-0.5)};
  scene.space.upper = {Number(0.5), Number(0.5)};
  scene.balls = {ball({0.5, parse_number("0.1")}, {1.0, 0.0}, 0.0), ball({0.0, 0.0}, {0.0, 0.0})};
  scene.balls[1].radius = parse_number("1/3");
  scene.balls[1].fixed = true;
  scene.run.events.reset();
  scene.run.until = Number(10.0);
  return scene;
}

/// Distance of the photon from the origin at t = 10, to the digits of the run.
std::string distance(const Scene& scene, const Precision& precision, std::int64_t reflections) {
  Simulation simulation(scene, precision);
  simulation.run();
  EXPECT_EQ(simulation.counts().collisions(), reflections);
  const BallState state = simulation.ball(0);
  const PrecisionScope<Multi> scope(precision.digits);
  const auto digits = [](const Number& x) { return x.text.empty() ? Multi(x.value) : Multi(x.text); };
  const Multi x = digits(state.unwrapped_position[0]), y = digits(state.unwrapped_position[1]);
  return Multi(sqrt(x * x + y * y)).str(precision.digits, std::ios_base::fixed);
}

// The published digits. 10.8 digits are lost on the way, so 60 give 48; and reading 0.1 as a double alone costs 3e-7.
TEST(Photon, at_sixty_digits) {
  const std::string r60 = distance(photon(), Precision::decimal(60), 14);
  EXPECT_EQ(r60.substr(0, 24), "0.9952629194433541608903");
  EXPECT_EQ(r60.substr(0, 48), distance(photon(), Precision::decimal(100), 14).substr(0, 48));
  EXPECT_EQ(distance(photon(), Precision::decimal(30), 14).substr(0, 18), r60.substr(0, 18));
  const std::string of_doubles = distance(rounded_to_double(photon()), Precision::decimal(60), 14);
  EXPECT_NEAR(std::stod(of_doubles) - std::stod(r60), 0.0, 1e-5);
  EXPECT_GT(std::abs(std::stod(of_doubles) - std::stod(r60)), 1e-8);
}

// The tangent map predicts a loss of 10.8 +- 0.5 digits over the 14 reflections, and double loses about that.
TEST(Photon, predicted_loss) {
  const Scene scene = photon();
  Simulation simulation(scene);
  TangentGrowth tangent(scene, simulation);
  std::int64_t reflections = 0;
  simulation.run([&](const Collision& c) {
    tangent.collision(c);
    ++reflections;
  });
  EXPECT_EQ(reflections, 14);
  EXPECT_NEAR(tangent.digits(), 10.8, 0.5);

  const Horizon horizon = find_horizon(scene, {});
  EXPECT_EQ(horizon.compared, 14);
  EXPECT_FALSE(horizon.partner);
  EXPECT_FALSE(horizon.percent);
  EXPECT_NEAR(std::log10(horizon.largest_error / 1e-16), *horizon.digits_lost, 1.5);
  EXPECT_NEAR(*horizon.digits_per_collision, 0.77, 0.04);
  EXPECT_GT(horizon.input_error, horizon.largest_error / 1000);
}

// The displacement that the tangent map predicts is the one that two runs side by side show: in a box with a circle, a
// slope, gravity, unequal masses and e < 1, a start moved by 1e-9 arrives moved by 1e-9 times the growth.
TEST(TangentGrowth, is_the_derivative_of_the_run) {
  for (const double g : {0.0, -1.0}) {
    Scene scene = box({0, 0}, {4, 3});
    if (g != 0) scene.motion.acceleration = {0.25, g};
    scene.collision.restitution = 0.9;
    scene.balls = {ball({1, 1}, {1, 0.3}, 0.3, 2), ball({3, 1.4}, {-1.2, 0.1}, 0.25, 1)};
    WallSpec circle;
    circle.kind = WallKind::circle;
    circle.centre = {2.0, 2.4};
    circle.radius = 0.2;
    circle.side = WallSide::outside;
    scene.walls = {circle};
    scene.run.events = 12;

    const auto run = [](const Scene& s, TangentGrowth* tangent) {
      Simulation simulation(s);
      Collision last;
      simulation.run([&](const Collision& c) {
        last = c;
        if (tangent != nullptr) tangent->collision(c);
      });
      EXPECT_EQ(simulation.counts().collisions(), 12);
      return simulation;
    };
    Simulation start(scene);
    TangentGrowth tangent(scene, start);
    Simulation plain = run(scene, &tangent);
    // A moment later: at the collision itself a displaced ball may still be on its way to it.
    const Number later = plain.time() + 1e-3;
    plain.advance(later);
    EXPECT_EQ(plain.counts().collisions(), 12);
    double largest = 0;
    const double delta = 1e-9;
    for (std::size_t b = 0; b < 2; ++b)
      for (std::size_t k = 0; k < 2; ++k) {
        Scene moved = scene;
        moved.balls[b].position[k] = scene.balls[b].position[k] + delta;
        moved.run.events.reset();
        moved.run.until = later;
        Simulation other(moved);
        other.run();
        for (std::uint32_t i = 0; i < 2; ++i) {
          double square = 0;
          for (std::size_t d = 0; d < 2; ++d)
            square += std::pow(other.ball(i).position[d] - plain.ball(i).position[d], 2);
          largest = std::max(largest, std::sqrt(square) / delta);
        }
      }
    EXPECT_NEAR(std::log10(largest), tangent.digits(), 0.02) << "g = " << g;
  }
}

// Thirty disks: chaos. The run in double meets whom it should for some collisions, then parts from the truth; where it does
// agrees with the growth of errors from 1e-16 to the size of a radius.
TEST(Horizon, of_a_gas) {
  Scene scene = box({0, 0}, {10, 10});
  GasSpec gas;
  gas.count = 30;
  gas.packing_fraction = Number(0.3);
  scene.gases = {gas};
  scene.run.events = 5000;
  const Horizon h = find_horizon(scene, {});
  ASSERT_TRUE(h.partner && h.percent);
  EXPECT_LE(h.percent->event, h.partner->event);
  EXPECT_GT(h.percent->event, 50);
  EXPECT_LT(h.partner->event, 2000);
  EXPECT_NEAR(*h.digits_lost, 16, 4);
  HorizonOptions finer;
  finer.digits = 100;
  EXPECT_EQ(find_horizon(scene, finer).partner->event, h.partner->event) << "50 digits are the truth that far";
}

// Integrable: a ball between two walls. Errors do not grow, and no horizon is found.
TEST(Horizon, of_a_regular_motion_is_not_reached) {
  Scene scene = box({0, 0}, {1, 1});
  scene.balls = {ball({0.3, 0.4}, {1, 0.7}, 0.1)};
  scene.run.events = 3000;
  const Horizon h = find_horizon(scene, {});
  EXPECT_EQ(h.compared, 3000);
  EXPECT_FALSE(h.partner || h.percent);
  EXPECT_LT(h.largest_error, 1e-11);
}

// Three points on a line, the first of which hits two at rest: ceil(pi / phi) - 1 impacts with cos phi = (1 + r) / (4 sqrt r)
// above r = 7 - 4 sqrt 3, infinitely many below [McNamara1992]. At 100 digits both sides are told apart within 1e-5: 286
// impacts above, a collapse below; in their centre of mass, where the velocities that fade are all there is.
TEST(Precision, collapse_at_a_hundred_digits) {
  const auto run_at = [](const char* r) {
    Scene scene = open_space(1);
    scene.collision.restitution = parse_number(r);
    scene.balls = {ball({-1}, {parse_number("2/3")}, 0.0), ball({0}, {parse_number("-1/3")}, 0.0),
                   ball({0.5}, {parse_number("-1/3")}, 0.0)};
    Simulation simulation(scene, Precision::decimal(100));
    const Stop stop = simulation.run();
    return std::pair(stop, simulation.counts().ball_ball);
  };
  // 7 - 4 sqrt 3 +- 1e-5
  EXPECT_EQ(run_at("0.0718067697244908258902146339765105160"), std::pair(Stop::no_events_left, std::int64_t{286}));
  EXPECT_EQ(run_at("0.0717867697244908258902146339765105160").first, Stop::collapse);
}

// Every digit asked for is there: head-on, e = 1/3, masses 2 and 3: velocities are rational numbers.
TEST(Precision, gives_all_digits) {
  Scene scene = open_space(1);
  scene.collision.restitution = parse_number("1/3");
  scene.balls = {ball({-2}, {5}, 0.5, 2), ball({2}, {-1}, 0.5, 3)};
  scene.run.events = 1;
  Simulation simulation(scene, Precision::decimal(40));
  simulation.run();
  // v1 = (10 - 3 - 3 (6) / 3) / 5 = 1/5, v2 = (10 - 3 + 2 (6) / 3) / 5 = 11/5
  const PrecisionScope<Multi> scope(40);
  EXPECT_LT(abs(Multi(Multi(simulation.ball(0).velocity[0].text) - Multi(1) / 5)), Multi("1e-39"));
  EXPECT_LT(abs(Multi(Multi(simulation.ball(1).velocity[0].text) - Multi(11) / 5)), Multi("1e-39"));
  EXPECT_EQ(simulation.summary().precision, "40");
  EXPECT_LT(simulation.summary().energy.relative_error, 1e-39);
}

// A touching rack whose coordinates are given to as many digits as a double has starts in contact at any precision.
TEST(Precision, start_contacts_are_those_of_double) {
  Scene scene = open_space(2);
  scene.balls = {ball({0, 0}, {0, 0}), ball({parse_number("0.8660254037844386"), parse_number("0.5")}, {0, 0}),
                 ball({parse_number("0.8660254037844386"), parse_number("-0.5")}, {0, 0}), ball({-3, 0}, {1, 0})};
  scene.run.events = 3;
  for (const Precision& p : {Precision{}, Precision::decimal(50), Precision{Precision::Kind::long_double, 0}}) {
    Simulation simulation(scene, p);
    simulation.run();
    EXPECT_EQ(simulation.counts().ball_ball, 3) << p.text();
  }
}

// A checkpoint in 60 digits goes on bit for bit.
TEST(Precision, resumes) {
  const Scene scene = photon();
  for (const Precision& p : {Precision::decimal(60), Precision{Precision::Kind::long_double, 0}}) {
    Simulation whole(scene, p), first(scene, p), second(scene, p);
    whole.run();
    first.advance(scene.run.until, 7);
    second.restore(first.state());
    second.run();
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_EQ(second.ball(0).position[k].text, whole.ball(0).position[k].text) << p.text();
    Simulation other(scene, Precision::decimal(61));
    EXPECT_THROW(other.restore(first.state()), InputError);
  }
}

}  // namespace
}  // namespace carom
