// The circles that a ball is said to come to first hold the one that it meets first of all.

#include "carom/predict/next_circles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "carom/solve/quadratic.hpp"
#include "carom/world/state.hpp"
#include "carom/world/wall_images.hpp"

namespace carom {
namespace {

using Vector = Vec<double, 2>;
using Circle = Sphere<double, 2>;

struct Plane {
  Space<double, 2> space;
  std::vector<Circle> circles;
  double radius = 0;  // of the ball
};

Plane plane(double width, double height, double radius, const std::vector<std::array<double, 3>>& circles) {
  Plane p;
  p.space.kind = SpaceKind::periodic;
  p.space.lower = Vector(-0.3, 0.2);
  p.space.edge = Vector(width, height);
  p.radius = radius;
  for (const auto& [x, y, r] : circles) {
    Circle& c = p.circles.emplace_back();
    c.centre = Vector(x, y);
    c.velocity = Vector::Zero();
    c.radius = r;
    c.inside = false;
  }
  return p;
}

struct Hit {
  double flight = never<double>();
  Vector centre = Vector::Zero();
};

/// Of all circles up to nine periods away but the one that is left.
Hit by_looking_at_all(const Plane& p, const Vector& x, const Vector& v, std::uint32_t left, const Image<2>& its_image) {
  Hit first;
  for (std::uint32_t row = 0; row < p.circles.size(); ++row) {
    Image<2> n;
    for (n[0] = its_image[0] - 9; n[0] <= its_image[0] + 9; ++n[0])
      for (n[1] = its_image[1] - 9; n[1] <= its_image[1] + 9; ++n[1]) {
        if (row == left && n == its_image) continue;
        const Circle c = moved_by(p.space, p.circles[row], n);
        const double t = meet_time<double, 2>(x - c.centre, v, c.radius + p.radius);
        if (t < first.flight) first = {t, c.centre};
      }
  }
  return first;
}

/// `known`: the list goes as far as that.
Hit by_list(const NextCircles& next, const Vector& x, const Vector& v, std::uint32_t left, const Image<2>& image, bool& known) {
  Hit first;
  const NextCircles::Range range = next.from(left, image, v);
  for (const FourCircles* four = range.begin; four != range.end; ++four) {
    for (std::size_t m = 0; m < lanes; ++m) {
      const Vector centre(four->x[m], four->y[m]);
      const double t = meet_time<double, 2>(x - centre, v, four->sigma[m]);
      if (t < first.flight) first = {t, centre};
    }
    known = first.flight * first.flight * dot<double, 2>(v, v) < four->within;
    if (known) break;
  }
  return first;
}

TEST(NextCircles, hold_what_is_met_first) {
  const double height = 2.3 * std::sqrt(3.0);
  const std::vector<Plane> planes = {
      plane(2.3, height, 0, {{0, 0, 1}, {1.15, height / 2, 1}}),        plane(1, 1, 0, {{5.2, -2.3, 0.35}}),
      plane(1, 1, 0.1, {{0, 0, 0.39}}),                                 plane(1, 1.5, 0, {{0, 0, 0.3}, {0.2, 0.4, 0.3}}),
      plane(2, 1, 0.02, {{0, 0, 0.3}, {1, 0.1, 0.05}, {0.9, 0.7, 0.001}}), plane(1, 1, 0, {{0, 0, 0.02}}),
  };
  std::mt19937_64 bits(7);
  const auto unit = [&bits] { return static_cast<double>(bits() >> 11) * 0x1p-53; };
  for (const Plane& p : planes) {
    const NextCircles next(p.space, p.circles, p.radius, NextCircles::Of::walls);
    int known_in_all = 0;
    for (int k = 0; k < 4000; ++k) {
      const std::uint32_t left = static_cast<std::uint32_t>(bits() % p.circles.size());
      const Circle& circle = p.circles[left];
      const double reach = circle.radius + p.radius, place = 6.283185307179586 * unit(), way = place + 3.14 * (unit() - 0.5);
      Vector x = circle.centre + reach * Vector(std::cos(place), std::sin(place)), v(std::cos(way), std::sin(way));
      if (k % 16 == 0) v = Vector(k % 32 == 0 ? 1.0 : -1.0, 0.0);  // along an axis
      if (v[0] * std::cos(place) + v[1] * std::sin(place) < 0) v = -v;
      v *= std::exp2(20 * unit() - 10);
      const Turns<2> turns = wrap(p.space, x);
      Image<2> image;
      for (int a = 0; a < 2; ++a) image[a] = -static_cast<std::int32_t>(turns[static_cast<std::size_t>(a)]);
      bool known = false;
      const Hit found = by_list(next, x, v, left, image, known);
      if (!known) continue;
      ++known_in_all;
      const Hit all = by_looking_at_all(p, x, v, left, image);
      ASSERT_EQ(found.flight, all.flight);
      ASSERT_EQ(found.centre, all.centre);
    }
    EXPECT_GT(known_in_all, p.circles[0].radius < 0.1 ? 100 : 3000);
  }
}

// Every direction has its sector, and those beside an axis or a diagonal belong to one of the two that meet there.
TEST(NextCircles, sectors_cover_all_directions) {
  std::array<int, 32> seen{};
  for (int k = 0; k < 6400; ++k) {
    const double angle = 6.283185307179586 * (k + 0.5) / 6400;
    const std::uint32_t s = NextCircles::sector(std::cos(angle), std::sin(angle));
    ASSERT_LT(s, 32u);
    ++seen[s];
  }
  for (const int n : seen) EXPECT_GT(n, 6400 * 8.0 / 360);
}

}  // namespace
}  // namespace carom
