#include "carom/observe/poincare.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace carom {

namespace {

double dot(const std::array<double, 2>& n, const Triple& v) { return n[0] * v[0] + n[1] * v[1]; }

/// The time at which f0 + w s + g s^2 / 2 comes to f0 + c from below, on its rising branch.
double rising_root(double w, double g, double c) {
  const double speed = std::sqrt(std::max(0.0, w * w + 2 * g * c));  // there
  if (w >= 0) return c == 0 ? 0.0 : 2 * c / (speed + w);
  return (speed - w) / g;
}

}  // namespace

std::string Poincare::refusal(const PoincareSpec& spec, const Subject& subject) {
  if (subject.dimension != 2) return "a line divides only a plane";
  if (subject.accelerated() && subject.magnetic != 0) return "the flight has no closed form";
  const bool upright = spec.normal[0].value == 0 || spec.normal[1].value == 0;
  if (subject.space == SpaceKind::periodic && !upright) return "in a periodic space only a line along an axis closes";
  return "";
}

Poincare::Poincare(const PoincareSpec& spec, const RowOutlet& outlet, const Subject& subject)
    : outlet_(&outlet),
      began_((static_cast<double>(subject.moment.epoch) + subject.moment.offset) * subject.epoch_length),
      sums_(subject.epoch_length) {
  const double nx = spec.normal[0], ny = spec.normal[1], size = std::hypot(nx, ny);
  point_ = {spec.point[0], spec.point[1]};
  normal_ = {nx / size, ny / size};
  along_ = {normal_[1], -normal_[0]};
  if (subject.space != SpaceKind::periodic) return;
  period_ = subject.edge[ny == 0 ? 0 : 1];
  across_ = subject.edge[ny == 0 ? 1 : 0];
}

void Poincare::crossed(const Flight& f, double s) {
  sums_.add(f.begin + s, {0, 1});
  if (!outlet_->open()) return;
  Triple x = f.departure, v = f.velocity;
  if (f.magnetic != 0) {
    const double angle = f.magnetic * s, half = std::sin(angle / 2);
    const double along = std::sin(angle) / f.magnetic, across = 2 * half * half / f.magnetic;
    x[0] += along * f.velocity[0] - across * f.velocity[1];
    x[1] += across * f.velocity[0] + along * f.velocity[1];
    v[0] = std::cos(angle) * f.velocity[0] - std::sin(angle) * f.velocity[1];
    v[1] = std::sin(angle) * f.velocity[0] + std::cos(angle) * f.velocity[1];
  } else {
    for (std::size_t k = 0; k < 2; ++k) {
      x[k] += s * (v[k] + s / 2 * f.acceleration[k]);
      v[k] += s * f.acceleration[k];
    }
  }
  double position = along_[0] * (x[0] - point_[0]) + along_[1] * (x[1] - point_[1]);
  if (across_ > 0) position -= across_ * std::floor(position / across_);
  (*outlet_)(std::array{position, dot(along_, v), static_cast<double>(f.ball), began_ + (f.begin + s)});
}

/// Between s_from and s_to the height over the line rises from `from` to `to`.
void Poincare::crossings(const Flight& f, double from, double to, double s_from, double s_to) {
  if (!(from < to)) return;
  const double start = dot(normal_, f.departure) - normal_[0] * point_[0] - normal_[1] * point_[1];
  const double w = dot(normal_, f.velocity), g = dot(normal_, f.acceleration);
  const auto cross = [&](double level) { crossed(f, std::clamp(rising_root(w, g, level - start), s_from, s_to)); };
  if (period_ == 0) {
    if (from < 0 && to >= 0) cross(0);
    return;
  }
  for (double image = std::floor(from / period_) + 1; image * period_ <= to; ++image) cross(image * period_);
}

/// f(s) = f_c + (|v| / omega) sin psi, psi = omega s - delta; it rises where cos psi > 0.
void Poincare::round(const Flight& f) {
  const double a = dot(normal_, f.velocity), b = normal_[1] * f.velocity[0] - normal_[0] * f.velocity[1];
  const double speed = std::hypot(a, b), omega = f.magnetic, delta = std::atan2(b, a);
  if (speed == 0) return;
  const double start = dot(normal_, f.departure) - normal_[0] * point_[0] - normal_[1] * point_[1];
  const double centre = start + b / omega, reach = speed / std::abs(omega);
  const double turn = 2 * std::numbers::pi / std::abs(omega);
  std::vector<double> times;
  const auto level = [&](double height) {
    const double psi = std::asin(std::clamp((height - centre) * omega / speed, -1.0, 1.0));
    double s = std::fmod((psi + delta) / omega, turn);
    if (s <= 0) s += turn;
    for (; s <= f.duration; s += turn) times.push_back(s);
  };
  if (period_ == 0) {
    if (std::abs(centre) < reach) level(0);
  } else {
    for (double image = std::floor((centre - reach) / period_) + 1; image * period_ < centre + reach; ++image)
      level(image * period_);
  }
  std::sort(times.begin(), times.end());
  for (const double s : times) crossed(f, s);
}

void Poincare::flight(const Flight& f) {
  if (f.magnetic != 0) return round(f);
  const auto height = [&](const Triple& x) {
    return normal_[0] * (x[0] - point_[0]) + normal_[1] * (x[1] - point_[1]);
  };
  const double from = height(f.departure), to = height(f.arrival);
  const double w = dot(normal_, f.velocity), g = dot(normal_, f.acceleration);
  const double top = g == 0 ? 0.0 : -w / g;  // where the height turns
  if (!(top > 0 && top < f.duration)) return crossings(f, from, to, 0, f.duration);
  const double turning = from - w * w / (2 * g);
  if (g > 0) return crossings(f, turning, to, top, f.duration);
  crossings(f, from, turning, 0, top);
}

void Poincare::end(double t) {
  sums_.spread(0, t, {t, 0});
  sums_.end(t);
}

Estimates Poincare::estimates() const {
  return {sums_.estimate("poincare.rate", [](const auto& s) { return s[1] / s[0]; })};
}

}  // namespace carom
