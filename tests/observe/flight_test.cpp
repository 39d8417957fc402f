// Path lengths, moments and times at speeds of parabolic flights, against numerical integration.

#include "carom/observe/flight.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "carom/core/random.hpp"

namespace carom {
namespace {

double speed_at(const Flight& f, double s) {
  double squares = 0;
  for (std::size_t k = 0; k < 3; ++k) squares += std::pow(f.velocity[k] + s * f.acceleration[k], 2);
  return std::sqrt(squares);
}

/// int g(|v(s)|) ds by the midpoint rule on each of n parts.
template <class G>
double integral(const Flight& f, int n, G g) {
  double sum = 0;
  for (int i = 0; i < n; ++i) sum += g(speed_at(f, (i + 0.5) * f.duration / n));
  return sum * f.duration / n;
}

Flight flight(Triple v, Triple a, double t) {
  Flight f;
  f.velocity = v;
  f.acceleration = a;
  f.end = f.duration = t;
  return f;
}

TEST(Flight, along_a_straight_line) {
  const Flight f = flight({3, 4, 0}, {}, 2);
  EXPECT_EQ(f.path(), 10);
  EXPECT_EQ(f.square(), 50);
  EXPECT_EQ(f.fourth(), 1250);
  EXPECT_EQ(f.top_speed(), 5);
  EXPECT_EQ(f.time_below(5), 0);
  EXPECT_EQ(f.time_below(5.1), 2);
}

// Thrown up at speed v under g and back after 2 v / g: the path is v^2 / g, twice the height.
TEST(Flight, straight_up_and_down) {
  const Flight f = flight({0, 3, 0}, {0, -10, 0}, 0.6);
  EXPECT_NEAR(f.path(), 0.9, 1e-15);
  EXPECT_NEAR(f.square(), 9 * 0.6 / 3, 1e-15);
  EXPECT_NEAR(f.time_below(1), 0.2, 1e-15);
  EXPECT_EQ(f.time_below(3.5), 0.6);
}

TEST(Flight, of_no_time_or_from_rest) {
  EXPECT_EQ(flight({1, 2, 3}, {0, -1, 0}, 0).path(), 0);
  EXPECT_EQ(flight({0, 0, 0}, {0, -1, 0}, 0).path(), 0);
  EXPECT_EQ(flight({0, 0, 0}, {0, -2, 0}, 3).path(), 9);
  EXPECT_EQ(flight({0, 0, 0}, {}, 3).path(), 0);
}

TEST(Flight, agrees_with_numerical_integration) {
  RandomStream random(7, 0);
  for (int i = 0; i < 200; ++i) {
    Triple v, a;
    for (std::size_t k = 0; k < 3; ++k) v[k] = random.normal(), a[k] = random.normal();
    const Flight f = flight(v, a, 3 * random.uniform());
    EXPECT_NEAR(f.path(), integral(f, 4000, [](double s) { return s; }), 1e-5 * f.path());
    EXPECT_NEAR(f.square(), integral(f, 4000, [](double s) { return s * s; }), 1e-5 * f.square());
    EXPECT_NEAR(f.fourth(), integral(f, 4000, [](double s) { return s * s * s * s; }), 1e-5 * f.fourth());
    const double middle = 0.5 * (f.top_speed() + speed_at(f, f.duration / 2));
    EXPECT_NEAR(f.time_below(middle), integral(f, 4000, [&](double s) { return s < middle ? 1.0 : 0.0; }),
                2e-3 * f.duration);
  }
}

// A pull so weak that the parabola is a straight line up to rounding: |v| t (1 + (v.a) t / (2 v.v)), whatever the pull.
TEST(Flight, loses_no_digits_to_a_weak_pull) {
  for (double pull = 1; pull > 1e-200; pull /= 1e7) {
    const double g = pull * 1e-10;
    for (const double up : {1.0, -1.0}) {
      const Flight f = flight({0.6, up * 0.8, 0}, {0, -g, 0}, 1.5);
      EXPECT_NEAR(f.path(), 1.5 * (1 - up * 0.8 * g * 0.75), 4e-16 * 1.5) << g;
    }
  }
}

}  // namespace
}  // namespace carom
