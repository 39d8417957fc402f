#pragma once
// Curved walls about the origin, turned by the angle whose cosine is 0.6.

#include <utility>
#include <vector>

#include "carom/shape/ellipse.hpp"
#include "carom/shape/polar_curve.hpp"

namespace carom::testing {

[[nodiscard]] inline Ellipse<double> ellipse(double a, double b, bool inside) {
  Ellipse<double> e;
  e.centre = e.velocity = Vec<double, 2>(0, 0);
  e.axis = Vec<double, 2>(0.6, 0.8);
  e.a = a;
  e.b = b;
  e.round = 2 * pi<double>();
  e.inside = inside;
  return e;
}

[[nodiscard]] inline PolarCurve<double> polar(std::vector<double> cosines, std::vector<double> sines, bool inside) {
  PolarCurve<double> c;
  c.centre = c.velocity = Vec<double, 2>(0, 0);
  c.axis = Vec<double, 2>(0.6, 0.8);
  c.cosines = std::move(cosines);
  c.sines = std::move(sines);
  c.round = 2 * pi<double>();
  c.inside = inside;
  return c;
}

}  // namespace carom::testing
