#include "carom/observe/flight.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

double dot(const Triple& a, const Triple& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// |v(s)| as sqrt(across^2 + (along + s pull)^2).
struct Split {
  double pull, along, across;
};

Split split(const Flight& f) {
  const double pull = std::hypot(f.acceleration[0], f.acceleration[1], f.acceleration[2]);
  Triple direction{}, across{};
  for (std::size_t k = 0; k < 3; ++k) direction[k] = f.acceleration[k] / pull;
  const double along = dot(f.velocity, direction);
  for (std::size_t k = 0; k < 3; ++k) across[k] = f.velocity[k] - along * direction[k];
  return {pull, along, std::sqrt(dot(across, across))};
}

/// asinh(w1/q) - asinh(w0/q), w1 = w0 + dw >= w0, s = sqrt(q^2 + w^2).
double asinh_difference(double w0, double w1, double dw, double q, double s0, double s1) {
  // Its sinh is (w1 s0 - w0 s1) / q^2; where both terms have one sign, the difference of squares is taken out.
  if (w0 * w1 <= 0) return std::asinh(w1 / q) - std::asinh(w0 / q);
  return std::asinh(dw * (w1 + w0) / (w1 * s0 + w0 * s1));
}

}  // namespace

double Flight::path() const {
  if (acceleration == Triple{}) return std::sqrt(dot(velocity, velocity)) * duration;
  const Split v = split(*this);
  const double dw = v.pull * duration, w0 = v.along, w1 = w0 + dw, q = v.across;
  const double s0 = std::hypot(w0, q), s1 = std::hypot(w1, q);
  if (s0 + s1 == 0 || duration == 0) return 0;
  // w1 s1 - w0 s0 = dw (s0 + s1)/2 + (w0 + w1) (s1 - s0)/2, s1 - s0 = dw (w0 + w1) / (s0 + s1)
  const double straight = duration / 4 * ((s0 + s1) + (w0 + w1) * (w0 + w1) / (s0 + s1));
  return q == 0 ? straight : straight + q * q / (2 * v.pull) * asinh_difference(w0, w1, dw, q, s0, s1);
}

double Flight::square() const {
  const double a = dot(velocity, velocity), b = dot(velocity, acceleration), c = dot(acceleration, acceleration);
  const double t = duration;
  return t * (a + t * (b + t * c / 3));
}

double Flight::fourth() const {
  const double a = dot(velocity, velocity), b = 2 * dot(velocity, acceleration), c = dot(acceleration, acceleration);
  const double t = duration;  // |v|^2 = a + b s + c s^2
  return t * (a * a + t * (a * b + t * ((b * b + 2 * a * c) / 3 + t * (b * c / 2 + t * c * c / 5))));
}

double Flight::time_below(double speed) const {
  if (acceleration == Triple{}) return std::sqrt(dot(velocity, velocity)) < speed ? duration : 0.0;
  const Split v = split(*this);
  const double h2 = (speed - v.across) * (speed + v.across);
  if (!(h2 > 0)) return 0;
  const double h = std::sqrt(h2);
  const double from = std::max(0.0, (-h - v.along) / v.pull), to = std::min(duration, (h - v.along) / v.pull);
  return std::max(0.0, to - from);
}

double Flight::top_speed() const {
  Triple last = velocity;
  for (std::size_t k = 0; k < 3; ++k) last[k] += duration * acceleration[k];
  return std::sqrt(std::max(dot(velocity, velocity), dot(last, last)));
}

}  // namespace carom
