// First meetings of balls on circles with curved walls against the definition, and against roots with 50 digits.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "carom/motion/magnetic_arc.hpp"
#include "carom/predict/ball_curve.hpp"
#include "carom/predict/traced_path.hpp"
#include "predict/curves.hpp"
#include "sim/scenes.hpp"

namespace carom {
namespace {

using testing::Dice;
using testing::ellipse;
using testing::polar;
using V = Vec<double, 2>;
using Path = CircularPath<MagneticArc<double>>;
using N = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

Parabola<double> parabola() {
  Parabola<double> p;
  p.centre = p.velocity = V(0, 0);
  p.axis = V(0.6, 0.8);
  p.focal_length = 0.5;
  p.half_width = 1.0;
  return p;
}

template <class Curve>
SidedFlight<double> flight(const Curve& curve, const Path& path, double radius, Touch touch, std::int8_t side) {
  if constexpr (requires { curve.home(); }) side = curve.home();
  return detail::traced_flight<double>(curve, path, radius, touch, side);
}

/// Distances of a path from 720 places on the curve, at 200 times before `until`: the least.
template <class Curve>
double least_distance(const Curve& curve, const Path& path, double until) {
  std::vector<V> places;
  for (int i = 0; i <= 720; ++i) places.push_back(curve.place(curve.begin() + (curve.end() - curve.begin()) * i / 720));
  double least = HUGE_VAL;
  for (int k = 0; k < 200; ++k)
    for (const V& y : places) least = std::min(least, length_of<double>(V(path.at(until * k / 200) - y)));
  return least;
}

// At the time found the ball touches, at none before; what is never met is not met within a turn.
template <class Curve>
void judge_flights(const Curve& curve, double box, std::uint64_t seed, int at_least) {
  Dice dice(seed);
  int met = 0;
  for (int i = 0; i < 40; ++i) {
    const double radius = i % 3 == 0 ? 0.0 : 0.05 * (i % 3);
    V x;
    do {
      const double p = dice.between(-box, box), q = dice.between(-box, box);
      x = V(p, q);
    } while (!(curve.gap(x) > radius + 1e-6));
    const double vx = dice.between(-1.0, 1.0), vy = dice.between(-1.0, 1.0), strength = std::exp2(dice.between(-8.0, 2.0));
    const MagneticArc<double> field{i % 2 == 0 ? strength : -strength};
    const Path path{field, x, V(vx, vy)};
    const SidedFlight<double> found = flight(curve, path, radius, Touch::none, 0);
    if (found.flight == never<double>()) {
      EXPECT_GT(least_distance(curve, path, std::min(path.period(), 50.0)), radius - 1e-9) << i;
      continue;
    }
    ++met;
    ASSERT_LE(found.flight, path.period());
    const V at = path.at(found.flight);
    const double gap = length_of<double>(V(at - curve.place(nearest_on<double>(curve, at)))) - radius;
    EXPECT_LE(std::abs(gap), 2e-14 * (1 + length_of<double>(at))) << i;
    EXPECT_GT(least_distance(curve, path, found.flight), radius - 1e-9) << i;
  }
  EXPECT_GE(met, at_least);
}

TEST(CurveInField, is_met_first_where_it_is_reached) {
  judge_flights(ellipse(2.0, 1.0, true), 2.0, 1, 25);
  judge_flights(ellipse(2.0, 1.0, false), 4.0, 2, 3);
  judge_flights(polar({1.0, 0.0, 0.1, 0.05}, {0.0, 0.1, 0.0, 0.02}, true), 1.2, 3, 25);
  judge_flights(polar({1.0, 0.0, 0.3}, {0.0, 0.0, 0.0}, false), 3.0, 4, 3);
  judge_flights(polar({1.0, 1.0}, {0.0, 0.0}, true), 2.0, 5, 15);  // a cardioid: with a cusp
  judge_flights(parabola(), 2.0, 6, 3);
}

/// Where (p / a)^2 + (q / b)^2 - 1 is 0 on the circle that x, v begin, next to t: halving, with 50 digits.
N crossing(const Ellipse<double>& e, double omega, const V& x, const V& v, double t) {
  const N w(omega);
  const auto form = [&](const N& s) {
    const N along = sin(N(w * s)) / w, across = (1 - cos(N(w * s))) / w;
    const N dx = N(x[0]) + along * N(v[0]) - across * N(v[1]), dy = N(x[1]) + along * N(v[1]) + across * N(v[0]);
    const N p = (N(e.axis[0]) * dx + N(e.axis[1]) * dy) / N(e.a), q = (N(e.axis[0]) * dy - N(e.axis[1]) * dx) / N(e.b);
    return N(p * p + q * q - 1);
  };
  N low = N(t) * (1 - N(1e-9)), high = N(t) * (1 + N(1e-9));
  if (!(form(low) < 0 && form(high) > 0)) return N(-1);
  for (int i = 0; i < 120; ++i) {
    const N middle = (low + high) / 2;
    (form(middle) < 0 ? low : high) = middle;
  }
  return low;
}

// A point inside an ellipse on a circle: the time is that of 50 digits, but for rounding over the sine of the angle of impact.
TEST(CurveInField, time_of_a_point_is_that_of_fifty_digits) {
  Dice dice(7);
  for (int i = 0; i < 150; ++i) {
    const double flat = std::exp2(dice.between(-3.0, 3.0)), p = dice.between(-0.6, 0.6), q = dice.between(-0.6, 0.6);
    const double vx = dice.between(-1.0, 1.0), vy = dice.between(-1.0, 1.0), omega = std::exp2(dice.between(-10.0, 0.0));
    Ellipse<double> e = ellipse(1.0, flat, true);
    e.axis = V(1, 0);
    const MagneticArc<double> field{omega};
    const Path path{field, V(p * e.a, q * e.b), V(vx, vy)};
    const double t = flight(e, path, 0.0, Touch::none, 0).flight;
    if (t == never<double>()) continue;
    const N exact = crossing(e, omega, path.x, path.v, t);
    ASSERT_GT(exact, 0) << i;
    const V at = path.at(t), then = path.velocity(t);
    const V out(at[0] / (e.a * e.a), at[1] / (e.b * e.b));
    const double closing = dot<double, 2>(out, then) / length_of<double>(out);
    EXPECT_LE(abs(N(N(t) - exact)), N(32 * 0x1p-53 * (e.size() + length_of<double>(path.v) * t) / closing)) << i;
  }
}

// What leaves a wall does not meet it at once: it comes back to it further on, on a small circle within a turn. A point that
// leaves a wall of two sides may meet it from the other one.
TEST(CurveInField, drops_the_contact_that_a_ball_comes_from) {
  Dice dice(10);
  const auto judge = [&](const auto& curve, double radius, double omega) {
    const double u = curve.begin() + (curve.end() - curve.begin()) * dice.between(0.05, 0.95);
    const V along = curve.along(u), n = V(-along[1], along[0]) / length_of<double>(along);
    const double up = dice.between(0.05, 1.0), on = dice.between(-1.0, 1.0);
    const MagneticArc<double> field{omega};
    const Path path{field, V(curve.place(u) + radius * n), V(up * n + on * along / length_of<double>(along))};
    const SidedFlight<double> next = flight(curve, path, radius, Touch::spent, 1);
    ASSERT_TRUE(!curve.closed() || next.flight < never<double>());
    if (next.flight == never<double>()) return;
    EXPECT_GT(next.flight, 1e-3);
    EXPECT_LE(next.flight, path.period() * (1 + 1e-12));
    const V at = path.at(next.flight);
    EXPECT_NEAR(length_of<double>(V(at - curve.place(nearest_on<double>(curve, at)))), radius, 2e-14);
    EXPECT_GT(least_distance(curve, path, next.flight), radius - 1e-9);
  };
  for (int i = 0; i < 25; ++i)
    for (const double radius : {0.0, 0.1})
      for (const double omega : {0.2, -3.0}) {
        judge(ellipse(2.0, 1.0, true), radius, omega);
        judge(polar({1.0, 0.2}, {0.0, 0.1}, true), radius, omega);
        judge(parabola(), radius, omega);
      }
}

}  // namespace
}  // namespace carom
