#pragma once
// Soft balls: while two overlap, a linear spring and a dashpot act between them.

#include <cmath>
#include <numbers>
#include <vector>

#include "carom/sim/fixed_step.hpp"
#include "carom/sim/fixed_step/contact_book.hpp"
#include "carom/sim/fixed_step/near_list.hpp"
#include "carom/sim/fixed_step/step_report.hpp"
#include "carom/sim/fixed_step/wall_contacts.hpp"

namespace carom {

/// The discrete element method [CundallStrack1979] with F = k d + 2 mu eta d' for an overlap d of a pair of reduced mass
/// mu: an impact lasts t_c = pi / omega, omega = sqrt(k / mu - eta^2), and has restitution e = exp(-eta t_c) [Luding1998],
/// so
///   eta = -ln(e) / t_c,   k = mu (omega^2 + eta^2).
/// For e = 0 the critical damping eta = omega_0 = pi / t_c is taken: they stay together.
struct SpringDashpot {
  double stiffness = 0;  ///< k / mu [1 / L^2]
  double damping = 0;    ///< 2 eta [1 / L]

  SpringDashpot() = default;
  SpringDashpot(double contact_time, double restitution) {
    const double omega = std::numbers::pi / contact_time;
    const double eta = restitution > 0 ? -std::log(restitution) / contact_time : omega;
    stiffness = (restitution > 0 ? omega * omega : 0.0) + eta * eta;
    damping = 2 * eta;
  }
};

/// Velocity Verlet; the damping sees v + a dt, with the acceleration of the step before.
template <int D>
class Penalty {
 public:
  Penalty(const PenaltyOptions& options, StepState<D>& s, bool every_pair)
      : near_(every_pair), walls_(s.world.walls), book_(s.size()) {
    const double t = options.contact_time ? std::ldexp(*options.contact_time, -s.world.units.time) : options.steps * s.dt;
    contact_time_ = t;
    lasting_steps_ = static_cast<std::int64_t>(std::ceil(2 * t / s.dt));
    for (std::uint32_t i = 0; i < s.size(); ++i)
      acceleration_.push_back(s.fixed(i) ? Vector(Vector::Zero()) : s.world.acceleration);
  }

  void step(StepState<D>& s, const StepReport& report) {
    for (std::uint32_t i = 0; i < s.size(); ++i) {
      s.v[i] += acceleration_[i] * (s.dt / 2);
      s.x[i] += s.v[i] * s.dt;
      ahead_.resize(s.size());
      ahead_[i] = s.v[i] + acceleration_[i] * (s.dt / 2);
    }
    ++s.steps;
    near_.ensure(s, 0);
    for (std::uint32_t i = 0; i < s.size(); ++i)
      acceleration_[i] = s.fixed(i) ? Vector(Vector::Zero()) : s.world.acceleration;
    press_walls(s);
    press_balls(s);
    for (std::uint32_t i = 0; i < s.size(); ++i) s.v[i] += acceleration_[i] * (s.dt / 2);
    tell(s, report);
    book_.turn();
  }

 private:
  using Vector = Vec<double, D>;
  using Contact = LastingContact<D>;

  void press_walls(const StepState<D>& s) {
    if (s.world.walls.empty()) return;
    for (std::uint32_t i = 0; i < s.size(); ++i) {
      if (s.immovable(i)) continue;
      walls_.near(s.x[i], s.radius[i], s.since_start(), 0, [&](const WallContact<D>& w) {
        const double e = s.world.restitution.at_wall(s.world.details[i].material, w.wall);
        const double parting = dot<double, D>(w.normal, Vector(ahead_[i] - w.velocity));
        const double push = push_per_mass(e, -w.gap, parting);
        acceleration_[i] += w.normal * push;
        note(Contact{EventKind::ball_wall, i, w.wall, w.feature}, -w.gap, push * s.dt / s.inverse_mass[i], s.steps);
      });
    }
  }

  void press_balls(const StepState<D>& s) {
    for (const auto& p : near_.pairs()) {
      const Vector r = s.separation(p.i, p.j, p.image);
      const double rr = dot<double, D>(r, r), sigma = s.radius[p.i] + s.radius[p.j];
      if (!(rr < sigma * sigma) || rr == 0) continue;
      const double distance = std::sqrt(rr);
      const Vector n = r / distance;
      const double e = s.world.restitution.between(s.world.details[p.i].material, s.world.details[p.j].material);
      const double push = push_per_mass(e, sigma - distance, dot<double, D>(n, Vector(ahead_[p.j] - ahead_[p.i])));
      const double force = push / (s.inverse_mass[p.i] + s.inverse_mass[p.j]);
      acceleration_[p.i] -= n * (force * s.inverse_mass[p.i]);
      acceleration_[p.j] += n * (force * s.inverse_mass[p.j]);
      note(Contact{EventKind::ball_ball, p.i, p.j, 0, s.lasting_image(p.i, p.j, p.image)}, sigma - distance, force * s.dt,
           s.steps);
    }
  }

  /// F / mu of an overlap whose sides part at the given speed.
  [[nodiscard]] double push_per_mass(double e, double overlap, double parting) {
    if (e != spring_for_ || spring_.stiffness == 0) {
      spring_ = SpringDashpot(contact_time_, e);
      spring_for_ = e;
    }
    return spring_.stiffness * overlap - spring_.damping * parting;
  }

  void note(const Contact& found, double overlap, double impulse, std::int64_t step) {
    Contact& c = book_.touch(found, step);
    c.overlap = std::max(c.overlap, overlap);
    c.impulse += impulse;
  }

  void tell(const StepState<D>& s, const StepReport& report) {
    const auto once = [&](Contact& c) {
      if (c.reported) return;
      report.contact(c, std::abs(c.impulse), report.time);
      c.reported = true;
    };
    for (Contact& c : book_.before())
      if (c.ended) once(c);
    for (Contact& c : book_.now())
      if (s.steps - c.since >= lasting_steps_) once(c);
  }

  double contact_time_;         // [L]
  std::int64_t lasting_steps_;  // after which a contact is told of before it ends
  double spring_for_ = 1;       // the restitution that spring_ is for
  SpringDashpot spring_;
  NearList<D> near_;
  WallContacts<D> walls_;
  ContactBook<D> book_;
  std::vector<Vector> acceleration_;  // [length unit / L^2] by ball
  std::vector<Vector> ahead_;         // [length unit / L] velocity that the damping sees, by ball
};

}  // namespace carom
