#include "carom/observe/virial_pressure.hpp"

#include <cmath>
#include <numbers>

#include "maxwell.hpp"

namespace carom {

namespace {

/// Periodic: about the centre of mass.
double kinetic_energy(const Subject& s) {
  double twice = 0, mass = 0;
  Triple momentum{};
  for (std::uint32_t i = 0; i < s.mass.size(); ++i) {
    if (!s.moves_freely(i)) continue;
    mass += s.mass[i];
    for (std::size_t k = 0; k < 3; ++k) {
      twice += s.mass[i] * s.velocity[i][k] * s.velocity[i][k];
      momentum[k] += s.mass[i] * s.velocity[i][k];
    }
  }
  if (s.space == SpaceKind::periodic)
    for (const double p : momentum) twice -= p * p / mass;
  return twice / 2;
}

}  // namespace

double VirialPressure::degrees_of_freedom(const Subject& subject) {
  const std::int64_t of = subject.space == SpaceKind::periodic ? subject.free - 1 : subject.free;
  return static_cast<double>(of * subject.dimension);
}

VirialPressure::VirialPressure(const Subject& subject)
    : dimension_(subject.dimension),
      count_(static_cast<double>(subject.free)),
      volume_(subject.volume()),
      freedom_(degrees_of_freedom(subject)),
      speed_factor_(std::sqrt(2 * std::numbers::pi) * mean_length_ratio(freedom_)),
      kinetic_(kinetic_energy(subject)),
      sums_(subject.epoch_length) {}

void VirialPressure::pass(double t) {
  sums_.spread(last_, t, {t - last_, kinetic_ * (t - last_), 0, 0});
  last_ = t;
}

void VirialPressure::collision(const Collision& c, double t, const Subject& subject) {
  pass(t);
  const std::uint32_t i = c.ball.number, j = c.partner.number;
  const bool wall = c.kind == EventKind::ball_wall;
  const double distance = wall ? subject.radius[i] : subject.radius[i] + subject.radius[j];
  const double reduced = wall ? subject.mass[i] : subject.mass[i] * subject.mass[j] / (subject.mass[i] + subject.mass[j]);
  const double kT = 2 * kinetic_ / freedom_;
  const double mean_impulse = (1 + c.restitution) / 2 * speed_factor_ * std::sqrt(reduced * kT);
  sums_.add(t, {0, 0, distance * c.impulse, distance * mean_impulse});
  kinetic_ += c.injected - c.dissipated;
}

void VirialPressure::end(double t) {
  pass(t);
  sums_.end(t);
}

Estimates VirialPressure::estimates() const {
  using Sums = decltype(sums_)::Sums;
  const auto kT = [this](const Sums& s) { return 2 * s[1] / (s[0] * freedom_); };
  const auto z = [this, kT](const Sums& s, double virial) { return 1 + virial / (dimension_ * count_ * kT(s) * s[0]); };
  Estimates list{sums_.estimate("pressure.Z", [&](const Sums& s) { return z(s, s[2]); }),
                 sums_.estimate("pressure.virial", [&](const Sums& s) { return z(s, s[2]) * count_ * kT(s) / volume_; }),
                 sums_.estimate("pressure.kT", kT)};
  if (dimension_ > 1) list.push_back(sums_.estimate("pressure.Z_rate", [&](const Sums& s) { return z(s, s[3]); }));
  return list;
}

}  // namespace carom
