// First meetings of balls with curved walls against the definition: at the time found the distance is the radius, and
// at none of many times before it was less.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "carom/predict/ball_arc.hpp"
#include "carom/predict/ball_curve.hpp"
#include "predict/curves.hpp"
#include "sim/scenes.hpp"

namespace carom {
namespace {

using testing::Dice;
using testing::ellipse;
using testing::polar;
using V = Vec<double, 2>;
using Digits50 = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

Arc<double> arc(double radius, double from, double turn) {
  Arc<double> a;
  a.centre = V(0.3, -0.2);
  a.velocity = V(0, 0);
  a.radius = radius;
  a.turn = turn;
  a.wide = turn > pi<double>();
  a.from = a.centre + radius * V(std::cos(from), std::sin(from));
  a.to = a.centre + radius * V(std::cos(from + turn), std::sin(from + turn));
  return a;
}

/// Distances of a path from 720 places on the curve, at 200 times before `until`: the least.
template <class Curve>
double least_distance(const Curve& curve, const ParabolicPath<double>& path, double until) {
  std::vector<V> places;
  for (int i = 0; i <= 720; ++i) places.push_back(curve.place(curve.begin() + (curve.end() - curve.begin()) * i / 720));
  double least = HUGE_VAL;
  for (int k = 0; k < 200; ++k)
    for (const V& y : places) least = std::min(least, length_of<double>(V(path.at(until * k / 200) - y)));
  return least;
}

template <class Curve>
void judge_flights(const Curve& curve, double box, std::uint64_t seed) {
  Dice dice(seed);
  int met = 0;
  for (int i = 0; i < 60; ++i) {
    const double radius = i % 3 == 0 ? 0.0 : 0.05 * (i % 3);
    V x;
    do {
      const double p = dice.between(-box, box), q = dice.between(-box, box);
      x = V(p, q);
    } while (!(curve.gap(x) > radius + 1e-6));
    const double vx = dice.between(-1.0, 1.0), vy = dice.between(-1.0, 1.0), ax = dice.between(-1.0, 1.0);
    const V v(vx, vy), a = i % 2 == 0 ? V(0, 0) : V(ax, -0.5);
    const SidedFlight<double> found =
        i % 2 == 0 ? flight_to_curve<false, double>(curve, x, v, a, radius, Touch::none, 0)
                   : flight_to_curve<true, double>(curve, x, v, a, radius, Touch::none, 0);
    const ParabolicPath<double> path{x, v, a};
    if (found.flight == never<double>()) {
      EXPECT_GT(least_distance(curve, path, 20.0), radius - 1e-9) << i;
      continue;
    }
    ++met;
    const V at = path.at(found.flight);
    const double gap = length_of<double>(V(at - curve.place(nearest_on<double>(curve, at)))) - radius;
    EXPECT_LE(std::abs(gap), 1e-14 * (1 + length_of<double>(at))) << i;
    EXPECT_GT(least_distance(curve, path, found.flight), radius - 1e-9) << i;
  }
  EXPECT_GT(met, 5);
}

TEST(CurveFlight, to_an_ellipse) {
  judge_flights(ellipse(2.0, 1.0, true), 2.0, 1);
  judge_flights(ellipse(2.0, 1.0, false), 4.0, 2);
}
TEST(CurveFlight, to_curves_in_polar_coordinates) {
  judge_flights(polar({1.0, 0.0, 0.1, 0.05}, {0.0, 0.1, 0.0, 0.02}, true), 1.2, 3);
  judge_flights(polar({1.0, 0.0, 0.3}, {0.0, 0.0, 0.0}, false), 3.0, 4);
  judge_flights(polar({1.0, 1.0}, {0.0, 0.0}, true), 2.0, 5);  // a cardioid: with a cusp
}
TEST(CurveFlight, to_a_parabola) {
  Parabola<double> p;
  p.centre = p.velocity = V(0, 0);
  p.axis = V(0.6, 0.8);
  p.focal_length = 0.5;
  p.half_width = 1.0;
  judge_flights(p, 2.0, 6);
}

// In the frame in which an ellipse is a circle a point's path is a line: its two crossings by the quadratic formula with 50
// digits. Sizes log-uniform over 2^-40 .. 2^40.
TEST(CurveFlight, of_a_point_in_an_ellipse_is_exact) {
  Dice dice(7);
  for (int i = 0; i < 2000; ++i) {
    const double scale = std::exp2(dice.between(-40.0, 40.0)), flat = std::exp2(dice.between(-6.0, 6.0));
    Ellipse<double> e = ellipse(scale, scale * flat, true);
    e.axis = V(1, 0);
    const double p = dice.between(-0.7, 0.7), q = dice.between(-0.7, 0.7), vx = dice.between(-1.0, 1.0), vy = dice.between(-1.0, 1.0);
    const V x(p * e.a, q * e.b), v(vx, vy);
    const double t = flight_to_curve<false, double>(e, x, v, V(0, 0), 0.0, Touch::none, 0).flight;
    using N = Digits50;
    const N rx = N(x[0]) / N(e.a), ry = N(x[1]) / N(e.b), wx = N(v[0]) / N(e.a), wy = N(v[1]) / N(e.b);
    const N aa = wx * wx + wy * wy, b = rx * wx + ry * wy, c = rx * rx + ry * ry - 1;
    const N exact = (-b + sqrt(N(b * b - aa * c))) / aa;
    EXPECT_LE(abs(N((N(t) - exact) / exact)), N(64 * 0x1p-53)) << i;
  }
}

// The first crossing of the circle of radius R +- s that lies between the ends, all crossings with 50 digits.
TEST(ArcFlight, is_the_first_crossing_between_the_ends) {
  Dice dice(8);
  int from_inside = 0, from_outside = 0, missed = 0;
  for (int i = 0; i < 4000; ++i) {
    const double from = dice.between(-3.0, 3.0), turn = dice.between(0.05, 6.2);
    const Arc<double> a = arc(1.0, from, turn);
    const double radius = i % 2 == 0 ? 0.0 : 0.2;
    const double p = dice.between(-2.0, 2.0), q = dice.between(-2.0, 2.0), vx = dice.between(-1.0, 1.0), vy = dice.between(-1.0, 1.0);
    const V x(p, q), v(vx, vy);
    if (std::abs(a.height(x)) < radius + 1e-3) continue;
    const SidedFlight<double> found = flight_to_arc<false, double>(a, x, v, V(0, 0), radius, Touch::none, 0);
    using N = Digits50;
    const N rx = N(x[0]) - N(a.centre[0]), ry = N(x[1]) - N(a.centre[1]), wx(v[0]), wy(v[1]);
    const N aa = wx * wx + wy * wy, b = rx * wx + ry * wy;
    N best = -1;
    int side = 0;
    bool close = false;  // to an end: decided by rounding
    for (const int s : {-1, 1}) {
      const N rho = N(a.radius) - N(s) * N(radius), d = b * b - aa * (rx * rx + ry * ry - rho * rho);
      if (d <= 0) continue;
      const N t = (-b + N(s) * sqrt(d)) / aa;  // inwards through the outer circle, outwards through the inner one
      if (t <= 0) continue;
      const double angle = std::atan2(static_cast<double>(ry + t * wy), static_cast<double>(rx + t * wx));
      double after = std::fmod(angle - from, 2 * pi<double>());
      if (after < 0) after += 2 * pi<double>();
      close = close || std::abs(after - turn) < 1e-9 || after < 1e-9 || after > 2 * pi<double>() - 1e-9;
      if (after < turn && (best < 0 || t < best)) {
        best = t;
        side = s;
      }
    }
    if (close) continue;
    if (best < 0) {
      EXPECT_EQ(found.flight, never<double>()) << i;
      ++missed;
      continue;
    }
    EXPECT_LE(abs(N((N(found.flight) - best) / best)), N(1e-12)) << i;
    EXPECT_EQ(found.side, side) << i;
    (side > 0 ? from_inside : from_outside) += 1;
  }
  EXPECT_GT(from_inside, 300);
  EXPECT_GT(from_outside, 100);
  EXPECT_GT(missed, 300);
}

// Free fall as the limit of no acceleration: the quartic and the quadratic find the same arc.
TEST(ArcFlight, with_hardly_any_acceleration_is_that_of_none) {
  Dice dice(9);
  for (int i = 0; i < 500; ++i) {
    const Arc<double> a = arc(1.0, dice.between(-3.0, 3.0), dice.between(0.5, 6.0));
    const double p = dice.between(-0.6, 0.6), q = dice.between(-0.6, 0.6), vx = dice.between(0.2, 1.0), vy = dice.between(-1.0, 1.0);
    const V x(p, q), v(vx, vy);
    const double radius = i % 2 == 0 ? 0.0 : 0.1;
    const SidedFlight<double> free = flight_to_arc<false, double>(a, x, v, V(0, 0), radius, Touch::none, 0);
    const SidedFlight<double> fall = flight_to_arc<true, double>(a, x, v, V(0, -1e-13), radius, Touch::none, 0);
    if (free.flight == never<double>()) continue;
    const V at = x + v * free.flight;
    const double margin = std::min(length_of<double>(V(at - a.from)), length_of<double>(V(at - a.to)));
    if (margin < radius + 1e-3) continue;
    EXPECT_NEAR(fall.flight, free.flight, 1e-9) << i;
    EXPECT_EQ(fall.side, free.side);
  }
}

// A point that has just hit a wall from inside does not hit it again at once, and a ball neither.
TEST(CurveFlight, drops_the_contact_that_it_comes_from) {
  Dice dice(10);
  const Ellipse<double> e = ellipse(2.0, 1.0, true);
  const PolarCurve<double> c = polar({1.0, 0.2}, {0.0, 0.1}, true);
  const auto judge = [&](const auto& curve, double radius) {
    const double u = dice.between(0.0, 6.28);
    const V along = curve.along(u), n = V(-along[1], along[0]) / length_of<double>(along);
    const double up = dice.between(0.05, 1.0), on = dice.between(-1.0, 1.0);
    const V x = curve.place(u) + radius * n, v = up * n + on * along / length_of<double>(along);
    const SidedFlight<double> next = flight_to_curve<false, double>(curve, x, v, V(0, 0), radius, Touch::spent, 1);
    ASSERT_LT(next.flight, never<double>());
    EXPECT_GT(next.flight, 1e-3);
    const V at = x + v * next.flight;
    EXPECT_NEAR(length_of<double>(V(at - curve.place(nearest_on<double>(curve, at)))), radius, 1e-14);
  };
  for (int i = 0; i < 200; ++i)
    for (const double radius : {0.0, 0.1}) {
      judge(e, radius);
      judge(c, radius);
    }
}

// At a small angle to a concave wall of curvature k the way to the next contact is 2 angle / k, k that of the curve on which the
// centre moves; the height over the wall is rounding long before.
TEST(CurveFlight, comes_back_to_a_wall_that_it_leaves_almost_along_it) {
  const Ellipse<double> e = ellipse(2.0, 1.0, true);
  const PolarCurve<double> c = polar({1.0, 0.0, 0.1, 0.05}, {0.0, 0.1, 0.0, 0.02}, true);
  const auto judge = [](const auto& curve, double u, double radius, double angle) {
    const TracedFrame<double> at = curve.frame(u);
    const double stretch = length_of<double>(at.along), k = cross2<double>(at.along, at.bend) / (stretch * stretch * stretch);
    const V along = at.along / stretch, n = at.left() / stretch, x = at.place + radius * n, v = along + angle * n;
    const double t = flight_to_curve<false, double>(curve, x, v, V(0, 0), radius, Touch::spent, 1).flight;
    EXPECT_NEAR(t * k / (1 - radius * k) / (2 * angle), 1.0, 200 * angle + 1e-3) << u << ' ' << radius << ' ' << angle;
  };
  for (const double u : {1.0, 3.0, 5.0})
    for (const double radius : {0.0, 0.1})
      for (const double angle : {1e-4, 1e-5, 1e-6}) {
        if (radius > 0) judge(e, u, radius, angle);  // a point has the closed form
        judge(c, u, radius, angle);
      }
}

}  // namespace
}  // namespace carom
