// What is sampled at equal distances of time, against what is known of gases.

#include "carom/observe/samplers.hpp"

#include <cmath>
#include <map>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "carom/core/error.hpp"
#include "carom/observe/enskog.hpp"
#include "carom/observe/observers.hpp"
#include "carom/scene/read.hpp"
#include "sim/scenes.hpp"

namespace carom {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using std::numbers::pi;

struct Sampled {
  std::map<std::string, Estimate> estimates;
  std::map<std::string, Table> tables;
  EventCounts counts;
  double time = 0;
  std::vector<BallState> balls;

  [[nodiscard]] const Estimate& at(const std::string& name) const { return estimates.at(name); }
};

Sampled sample(const Scene& scene) {
  Simulation simulation(scene);
  Observers observers(scene, simulation);
  Samplers samplers(scene, simulation);
  run_sampled(simulation, scene.run, samplers, observers.sink());
  observers.end(simulation);
  Sampled s{{}, {}, simulation.counts(), simulation.time(), simulation.balls()};
  for (const Estimates& list : {observers.estimates(), samplers.estimates()})
    for (const Estimate& e : list) s.estimates[e.name] = e;
  for (const Table& t : samplers.tables()) s.tables[t.name] = t;
  return s;
}

/// Balls of diameter 1 at a packing fraction.
Scene fluid(int dimension, int count, double packing, std::int64_t events, const std::string& observe) {
  return read_scene("dimension = " + std::to_string(dimension) + "\n[[gas]]\ncount = " + std::to_string(count) +
                        "\nradius = 0.5\npacking_fraction = " + std::to_string(packing) + "\n[run]\nevents = " +
                        std::to_string(testing::scaled_count(events)) + "\n[observe]\n" + observe,
                    "scene.toml");
}

/// Points that cross a periodic cell and never meet.
Scene points(int dimension, int count, const std::string& observe) {
  const std::string zero = dimension == 2 ? "[0, 0]" : "[0, 0, 0]", edge = dimension == 2 ? "[7, 5]" : "[7, 5, 6]";
  return read_scene("dimension = " + std::to_string(dimension) + "\nspace = { kind = \"periodic\", lower = " + zero +
                        ", upper = " + edge + " }\n[[gas]]\ncount = " + std::to_string(count) +
                        "\nradius = 0\n[run]\nuntil = 40\n[observe]\n" + observe,
                    "scene.toml");
}

// Points: pairs in a shell are N (N - 1)/2 times its share of the volume, in each sample, and g = 1. Samples 1 apart are
// independent, as points cross a bin in less.
TEST(RadialDistribution, of_points_is_one) {
  for (const int dimension : {2, 3}) {
    const Sampled s = sample(points(dimension, 300, "radial_distribution = { every = 1, bins = 10, r_max = 2.4 }"));
    const auto& rows = s.tables.at("radial_distribution").rows;
    ASSERT_EQ(rows.size(), 10u);
    for (const auto& row : rows) {
      EXPECT_NEAR(row[2], 1.0, 4.5 * row[3]) << "from " << row[0];
      EXPECT_LT(row[3], 0.2);
    }
    EXPECT_NEAR(rows.back()[2], 1.0, 0.02);
    EXPECT_EQ(s.estimates.size(), 0u) << "points have no contact";
  }
}

// Z = 1 + omega sigma^d g (N - 1)/(2 d V): from pairs near contact, from the number of collisions, and from the virial, which
// is measured by other means. Against the literature g(sigma) has the relative error of Z - 1, and an effect of 1/N.
TEST(RadialDistribution, at_contact_is_the_pressure) {
  struct Case {
    int dimension;
    double packing, g;  // [HansenGoos2016] at rho = 0.5; virial series of disks: (Z - 1)/(2 eta)
  };
  for (const auto& [d, packing, g] : {Case{3, pi / 12, 2.16712}, Case{2, 0.2, 1.4259125}}) {
    const int n = 500;
    const Sampled s = sample(fluid(d, n, packing, 250000, "after = { events = 20000 }\npressure = true\n"
                                                          "radial_distribution = { every = 0.2 }"));
    const double volume = n / packing * sphere_area(d) / d * std::pow(0.5, d);
    const double per_g = sphere_area(d) / (2 * d) * (n - 1) / volume;
    const Estimate &z = s.at("pressure.Z"), &contact = s.at("radial_distribution.contact"),
                   &rate = s.at("radial_distribution.contact_rate");
    EXPECT_NEAR(1 + per_g * contact.value, z.value, 4 * std::hypot(z.error, per_g * contact.error)) << d;
    EXPECT_NEAR(1 + per_g * rate.value, z.value, 4 * z.error) << d;
    EXPECT_NEAR(rate.value, g, 4 * rate.error + 0.006 * g) << d;
    EXPECT_LT(contact.error, 0.03 * g);
    EXPECT_GT(contact.error, 1e-5 * g);
    const auto& rows = s.tables.at("radial_distribution").rows;
    double inside = 0;
    for (const auto& row : rows)
      if (row[1] < 1 - 1e-9) inside += row[2];
    EXPECT_EQ(inside, 0.0) << "no two centres are nearer than a diameter";
  }
}

// Between collisions |x(t) - x(0)|^2 = v^2 t^2 and v(t) = v(0), for every ball: means are 2 E/(N m) t^2 and 2 E/(N m), with
// 2 E = d (N - 1) kT. The integral of a constant C to the last lag T is C T.
TEST(Correlations, of_free_flight_are_exact) {
  const double mean_square = 3 * 99.0 / 100;
  const Sampled s = sample(points(3, 100, "mean_squared_displacement = { every = 0.75, lags = 20, origins = 3 }\n"
                                          "velocity_autocorrelation = { every = 0.5, lags = 8 }"));
  const auto& msd = s.tables.at("mean_squared_displacement").rows;
  ASSERT_EQ(msd.size(), 21u);
  for (const auto& row : msd) EXPECT_NEAR(row[1], mean_square * row[0] * row[0], 1e-11 * (1 + row[1]));
  EXPECT_EQ(msd[4][0], 3.0);
  for (const auto& row : s.tables.at("velocity_autocorrelation").rows) EXPECT_NEAR(row[1], mean_square, 1e-12);
  EXPECT_NEAR(s.at("velocity_autocorrelation.initial").value, mean_square, 1e-12);
  EXPECT_NEAR(s.at("velocity_autocorrelation.diffusion").value, mean_square * 4 / 3, 1e-11);
}

// The slope of C at 0 is exact at any density: a collision takes v_n^2/2 off v . v(0) on the mean, and <v_n^2> = 4 kT/m over
// collisions, so -dC/dt / C = 2 Gamma/d. In a dilute gas C goes on nearly as an exponential.
TEST(Correlations, velocities_are_forgotten_at_the_rate_of_collisions) {
  const Sampled s = sample(fluid(3, 1000, 0.02, 200000, "velocity_autocorrelation = { every = 0.25, lags = 10 }"));
  const double rate = 2.0 * static_cast<double>(s.counts.ball_ball) / (1000 * s.time);
  const auto& c = s.tables.at("velocity_autocorrelation").rows;
  for (const std::size_t lag : {1u, 2u, 4u}) {
    const double expected = std::exp(-2 * rate * c[lag][0] / 3);
    EXPECT_NEAR(c[lag][1] / c[0][1], expected, 4 * c[lag][2] / c[0][1] + 0.005) << lag;
    EXPECT_LT(c[lag][2] / c[0][1], 0.02);
  }
}

// Diffusion at rho = 0.5: 0.247 (1 +- 0.06) at N = 1372 [Lue2005]; from displacements and from velocities alike.
TEST(Correlations, diffusion_is_the_same_from_displacements_and_from_velocities) {
  const Sampled s = sample(fluid(3, 1372, pi / 12, 450000, "after = { events = 30000 }\nmean_squared_displacement = { lags = 30 }\n"
                                                           "velocity_autocorrelation = { every = 0.02, lags = 150 }"));
  const Estimate &far = s.at("mean_squared_displacement.diffusion"), &kubo = s.at("velocity_autocorrelation.diffusion");
  EXPECT_NEAR(far.value, 0.247, 0.06 * 0.247 + 3 * far.error);
  EXPECT_NEAR(kubo.value, far.value, 4 * std::hypot(kubo.error, far.error));
  EXPECT_LT(far.error, 0.05 * far.value);
}

// A mean free time of Enskog's theory: 0.13017 at rho = 0.5 (1/Gamma of [HansenGoos2016]); Carnahan and Starling are 0.3 % off.
TEST(Enskog, free_time_is_near_the_measured_one) {
  const Scene scene = fluid(3, 4000, pi / 12, 1, "");
  EXPECT_NEAR(enskog_free_time(subject_of(scene, Simulation(scene))), 1 / 7.68223, 0.005 / 7.68223);
}

TEST(Samplers, change_nothing) {
  const Scene plain = fluid(2, 100, 0.3, 20000, "");
  const Scene asked = fluid(2, 100, 0.3, 20000, "radial_distribution = true\nmean_squared_displacement = true\n"
                                                "velocity_autocorrelation = true\nafter = { time = 0.3 }");
  const Sampled a = sample(plain), b = sample(asked);
  EXPECT_EQ(a.time, b.time);
  ASSERT_EQ(a.balls.size(), b.balls.size());
  for (std::size_t i = 0; i < a.balls.size(); ++i)
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_EQ(a.balls[i].position[k].value, b.balls[i].position[k].value);
      EXPECT_EQ(a.balls[i].velocity[k].value, b.balls[i].velocity[k].value);
    }
  EXPECT_EQ(b.tables.size(), 3u);
}

// A frame at the start of measuring and one after each interval: 1 + floor(4.5 / 0.5) origins' worth of lag 0.
TEST(Samplers, start_where_measuring_starts) {
  Scene scene = points(2, 10, "after = { time = 35.5 }\nvelocity_autocorrelation = { every = 0.5, lags = 9, origins = 10 }");
  const Sampled s = sample(scene);
  const auto& c = s.tables.at("velocity_autocorrelation").rows;
  EXPECT_NEAR(c[9][1], 2 * 9.0 / 10, 1e-12) << "35.5 and 40 are 9 lags apart";
  scene.observe.after_time = 35.75;
  EXPECT_TRUE(std::isnan(sample(scene).tables.at("velocity_autocorrelation").rows[9][1]));
  scene.observe.after_time = 50;
  EXPECT_TRUE(std::isnan(sample(scene).at("velocity_autocorrelation.initial").value));
}

std::vector<std::string> refused(const Scene& scene) {
  const Simulation simulation(scene);
  std::vector<std::string> what;
  try {
    const Samplers samplers(scene, simulation);
  } catch (const InputError& error) {
    for (const Problem& p : error.problems()) what.push_back(p.what + " | " + p.why);
  }
  return what;
}

TEST(Samplers, refuse_what_has_no_meaning) {
  Scene box = testing::box({0, 0}, {8, 8});
  box.balls = {testing::ball({2, 2}, {1, 0.5}), testing::ball({5, 5}, {-1, 0.25})};
  box.observe.radial_distribution.emplace();
  box.observe.mean_squared_displacement.emplace();
  EXPECT_THAT(refused(box), ElementsAre(HasSubstr("observe.radial_distribution has no meaning in this scene | near walls")));
  box.space.kind = SpaceKind::periodic;
  EXPECT_THAT(refused(box), ElementsAre());
  box.observe.radial_distribution->r_max = 4.1;
  EXPECT_THAT(refused(box), ElementsAre(HasSubstr("observe.radial_distribution.r_max is 4.1")));
  Scene open = testing::open_space(2);
  open.balls = box.balls;
  open.observe.velocity_autocorrelation.emplace();
  EXPECT_THAT(refused(open), ElementsAre(HasSubstr("observe.velocity_autocorrelation needs \"every\"")));
  open.observe.velocity_autocorrelation->every = 0.1;
  EXPECT_THAT(refused(open), ElementsAre());
  open.collision.law = LawKind::merge;
  EXPECT_THAT(refused(open), ElementsAre(HasSubstr("observe.velocity_autocorrelation has no meaning")));
}

TEST(Samplers, options_out_of_range_are_refused_by_name) {
  const auto problem = [](const std::string& observe) -> std::string {
    try {
      (void)points(2, 10, observe);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(problem("radial_distribution = { bins = 0 }"), HasSubstr("observe.radial_distribution.bins is 0"));
  EXPECT_THAT(problem("radial_distribution = { every = -1 }"), HasSubstr("observe.radial_distribution.every"));
  EXPECT_THAT(problem("mean_squared_displacement = { lags = 1 }"), HasSubstr("observe.mean_squared_displacement.lags is 1"));
  EXPECT_THAT(problem("velocity_autocorrelation = { bins = 3 }"), HasSubstr("bins"));
  EXPECT_THAT(problem("velocity_autocorrelation = 3"), HasSubstr("observe.velocity_autocorrelation"));
  EXPECT_EQ(problem("velocity_autocorrelation = false"), "");
}

}  // namespace
}  // namespace carom
