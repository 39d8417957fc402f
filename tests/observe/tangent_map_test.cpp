// The tangent map of impacts and flights against differences of the motion itself, in 50 digits.
//
// At time 0 the ball a touches b. A displaced a and b, by 1e-20 of anything, touch at another time: that time is found by
// Newton's method, the impact is carried out there, and both fly back to time 0 as they are after it. The displacement of
// that, over 1e-20, is the derivative up to 1e-20.

#include "carom/observe/tangent_map.hpp"

#include <cmath>
#include <functional>
#include <random>
#include <string>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

namespace carom {
namespace {

using Real = boost::multiprecision::cpp_bin_float_50;

template <int D>
using Vector = std::array<Real, static_cast<std::size_t>(D)>;

template <int D>
Real dot(const Vector<D>& a, const Vector<D>& b) {
  Real sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
  return sum;
}
template <int D>
Vector<D> plus(Vector<D> a, const Real& s, const Vector<D>& b) {
  for (std::size_t k = 0; k < a.size(); ++k) a[k] += s * b[k];
  return a;
}

/// A ball or a wall: x, v and what bends its path.
template <int D>
struct Body {
  Vector<D> x{}, v{}, g{};
  double omega = 0.0;  // or a rotation of v
  bool heavy = false;  // infinite mass, and not displaced

  [[nodiscard]] Vector<D> pull() const {
    Vector<D> a = g;
    if constexpr (D == 2) {
      a[0] -= omega * v[1];
      a[1] += omega * v[0];
    }
    return a;
  }
  [[nodiscard]] Body after(const Real& s) const {
    Body b = *this;
    if constexpr (D == 2)
      if (omega != 0) {
        const Real c = cos(omega * s), n = sin(omega * s);
        b.v = {c * v[0] - n * v[1], n * v[0] + c * v[1]};
        b.x = {x[0] + (n * v[0] - (1 - c) * v[1]) / omega, x[1] + ((1 - c) * v[0] + n * v[1]) / omega};
        return b;
      }
    b.x = plus<D>(plus<D>(x, s, v), s * s / 2, g);
    b.v = plus<D>(v, s, g);
    return b;
  }
};

/// The surface that the centre of a is reflected by, in the frame of b: where f = 0, with f > 0 outside, and its gradient.
template <int D>
struct Surface {
  std::function<Real(const Vector<D>&)> f;
  std::function<Vector<D>(const Vector<D>&)> gradient;
  double bend;  // 1 / sigma at the start
};

template <int D>
struct Case {
  Body<D> a, b;
  Surface<D> surface;
  double share_a, share_b, e;  // s = m_b / (m_a + m_b), and so on
};

template <int D>
Vector<D> normal(const Case<D>& c, const Body<D>& a, const Body<D>& b) {
  const Vector<D> g = c.surface.gradient(plus<D>(a.x, -1, b.x));
  return plus<D>(Vector<D>{}, 1 / sqrt(dot<D>(g, g)), g);
}

template <int D>
std::pair<Body<D>, Body<D>> through(const Case<D>& c, const Body<D>& a, const Body<D>& b) {
  Real s = 0;
  for (int round = 0; round < 8; ++round) {
    const Body<D> at = a.after(s), bt = b.after(s);
    const Vector<D> r = plus<D>(at.x, -1, bt.x), u = plus<D>(at.v, -1, bt.v);
    s -= c.surface.f(r) / dot<D>(c.surface.gradient(r), u);
  }
  Body<D> at = a.after(s), bt = b.after(s);
  const Vector<D> n = normal(c, at, bt);
  const Real kick = (1 + Real(c.e)) * dot<D>(plus<D>(at.v, -1, bt.v), n);
  at.v = plus<D>(at.v, -c.share_a * kick, n);
  bt.v = plus<D>(bt.v, c.share_b * kick, n);
  return {at.after(-s), bt.after(-s)};
}

template <int D>
void expect_derivative(const std::string& name, const Case<D>& c) {
  constexpr auto d = static_cast<std::size_t>(D);
  constexpr std::size_t count = 5;
  std::mt19937_64 bits(7);
  const auto draw = [&] { return static_cast<double>(bits() >> 11) * 0x1p-52 - 1; };
  std::vector<double> rows_a(2 * d * count), rows_b(2 * d * count, 0.0);
  for (double& x : rows_a) x = draw();
  if (!c.b.heavy)
    for (double& x : rows_b) x = draw();

  const auto [plain_a, plain_b] = through(c, c.a, c.b);
  const Real step("1e-20");
  std::vector<double> expected_a(rows_a.size()), expected_b(rows_b.size());
  for (std::size_t j = 0; j < count; ++j) {
    Body<D> a = c.a, b = c.b;
    for (std::size_t k = 0; k < d; ++k) {
      a.x[k] += step * rows_a[k * count + j];
      a.v[k] += step * rows_a[(d + k) * count + j];
      b.x[k] += step * rows_b[k * count + j];
      b.v[k] += step * rows_b[(d + k) * count + j];
    }
    const auto [moved_a, moved_b] = through(c, a, b);
    for (std::size_t k = 0; k < d; ++k) {
      expected_a[k * count + j] = static_cast<double>((moved_a.x[k] - plain_a.x[k]) / step);
      expected_a[(d + k) * count + j] = static_cast<double>((moved_a.v[k] - plain_a.v[k]) / step);
      expected_b[k * count + j] = static_cast<double>((moved_b.x[k] - plain_b.x[k]) / step);
      expected_b[(d + k) * count + j] = static_cast<double>((moved_b.v[k] - plain_b.v[k]) / step);
    }
  }

  TangentImpact<D> m;
  const Vector<D> n = normal(c, c.a, c.b);
  for (std::size_t k = 0; k < d; ++k) {
    m.normal[k] = static_cast<double>(n[k]);
    m.approach[k] = static_cast<double>(c.a.v[k] - c.b.v[k]);
    m.pull[k] = static_cast<double>(c.a.pull()[k] - c.b.pull()[k]);
    m.drop_a[k] = static_cast<double>(c.a.v[k] - plain_a.v[k]);
    m.drop_b[k] = static_cast<double>(c.b.v[k] - plain_b.v[k]);
    m.ease_a[k] = static_cast<double>(c.a.pull()[k] - plain_a.pull()[k]);
    m.ease_b[k] = static_cast<double>(c.b.pull()[k] - plain_b.pull()[k]);
  }
  m.bend = c.surface.bend;
  m.share_a = c.share_a * (1 + c.e);
  m.share_b = c.share_b * (1 + c.e);
  carry_through<D>(m, rows_a.data(), c.b.heavy ? nullptr : rows_b.data(), count);
  for (std::size_t k = 0; k < rows_a.size(); ++k) {
    EXPECT_NEAR(rows_a[k], expected_a[k], 1e-13 * (1 + std::abs(expected_a[k]))) << name << ", a " << k;
    if (c.b.heavy) continue;
    EXPECT_NEAR(rows_b[k], expected_b[k], 1e-13 * (1 + std::abs(expected_b[k]))) << name << ", b " << k;
  }
}

template <int D>
Surface<D> sphere(const Real& sigma, int sign) {
  return {[=](const Vector<D>& r) { return Real(sign * (dot<D>(r, r) - sigma * sigma)); },
          [=](const Vector<D>& r) { return plus<D>(Vector<D>{}, 2 * sign, r); }, static_cast<double>(sign / sigma)};
}

Surface<2> flat() {
  return {[](const Vector<2>& r) { return Real(Real(3) / 5 * r[0] + Real(4) / 5 * r[1]); },
          [](const Vector<2>&) { return Vector<2>{Real(3) / 5, Real(4) / 5}; }, 0.0};
}

TEST(TangentMap, of_two_balls) {
  Case<2> c{{{Real(3) / 2, Real(2)}, {-1, Real(1) / 4}, {}, 0, false}, {{}, {Real(1) / 2, Real(3) / 8}, {}, 0, false},
            sphere<2>(Real(5) / 2, 1), 0.6, 0.4, 1.0};
  expect_derivative("elastic", c);
  c.e = 0.5;
  expect_derivative("inelastic", c);
  c.a.g = {Real(1) / 4, -1};
  c.b.g = {0, -1};
  expect_derivative("under different accelerations", c);
  c.a.g = c.b.g = {};
  c.a.omega = c.b.omega = 0.75;
  expect_derivative("in a magnetic field", c);
  Case<3> space{{{1, 2, 2}, {-1, Real(1) / 4, -2}, {}, 0, false}, {{}, {Real(1) / 2, Real(3) / 8, 1}, {}, 0, false},
                sphere<3>(3, 1), 0.25, 0.75, 0.875};
  expect_derivative("in space", space);
  Case<1> line{{{2}, {-1}, {-1}, 0, false}, {{0}, {1}, {}, 0, false}, sphere<1>(2, 1), 0.25, 0.75, 0.5};
  expect_derivative("on a line", line);
}

TEST(TangentMap, of_walls) {
  const Body<2> ball{{Real(3) / 2, Real(2)}, {-1, -Real(1) / 4}, {}, 0, false}, wall{{}, {}, {}, 0, true};
  Case<2> c{ball, wall, sphere<2>(Real(5) / 2, 1), 1, 0, 0.75};
  expect_derivative("outside a circle", c);
  c.surface = sphere<2>(Real(5) / 2, -1);
  c.a.v = {1, Real(1) / 4};
  expect_derivative("inside a circle", c);
  c.a.omega = -1.25;
  expect_derivative("inside a circle, in a magnetic field", c);

  c = {{{4, -3}, {-1, -Real(1) / 4}, {}, 0, false}, wall, flat(), 1, 0, 0.75};
  expect_derivative("flat", c);
  c.b.v = {Real(1) / 8, Real(1) / 2};
  expect_derivative("flat, moving", c);
  c.b.g = {Real(3) / 8, -Real(7) / 8};
  c.a.g = {0, -1};
  expect_derivative("flat, swinging", c);

  // x^2 / 4 + y^2 = 1 at (6/5, 4/5), from inside: curvature a b / (a^2 sin^2 + b^2 cos^2)^(3/2).
  const Real square = 4 * Real(16) / 25 + Real(9) / 25;
  const double curvature = -static_cast<double>(2 / (square * sqrt(square)));
  c = {{{Real(6) / 5, Real(4) / 5}, {1, Real(1) / 4}, {}, 0, false}, wall, {}, 1, 0, 1.0};
  c.surface = {[](const Vector<2>& r) { return Real(1 - r[0] * r[0] / 4 - r[1] * r[1]); },
               [](const Vector<2>& r) { return Vector<2>{-r[0] / 2, -2 * r[1]}; }, bend_of_wall(curvature, 0)};
  expect_derivative("inside an ellipse", c);
}

TEST(TangentMap, parallel_walls_have_the_radius_added) {
  EXPECT_EQ(bend_of_wall(0, 0.5), 0);
  EXPECT_DOUBLE_EQ(bend_of_wall(0.5, 0.5), 1 / 2.5);
  EXPECT_DOUBLE_EQ(bend_of_wall(-0.5, 0.5), -1 / 1.5);
  EXPECT_DOUBLE_EQ(bend_of_wall(HUGE_VAL, 0.5), 1 / 0.5);
}

TEST(TangentMap, of_a_turning_flight) {
  const Real s = Real(7) / 8, step("1e-20");
  const double omega = -1.5;
  for (std::size_t k = 0; k < 4; ++k) {
    Body<2> a{{1, 2}, {3, -1}, {}, omega, false}, b = a;
    (k < 2 ? b.x[k] : b.v[k - 2]) += step;
    const Body<2> p = a.after(s), q = b.after(s);
    std::array<double, 4> rows{};
    rows[k] = 1;
    carry_round(rows.data(), 1, 0.875, omega);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_NEAR(rows[i], static_cast<double>((q.x[i] - p.x[i]) / step), 1e-15);
      EXPECT_NEAR(rows[2 + i], static_cast<double>((q.v[i] - p.v[i]) / step), 1e-15);
    }
  }
}

}  // namespace
}  // namespace carom
