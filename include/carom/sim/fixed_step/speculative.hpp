#pragma once
// Speculative contacts: pairs that could meet within the step are constrained before they do.

#include <algorithm>
#include <cmath>
#include <vector>

#include "carom/sim/fixed_step/contact_book.hpp"
#include "carom/sim/fixed_step/correction.hpp"
#include "carom/sim/fixed_step/near_list.hpp"
#include "carom/sim/fixed_step/step_report.hpp"
#include "carom/sim/fixed_step/wall_contacts.hpp"

namespace carom {

/// Continuous collision the way engines do it [Catto2013]: v += a dt; for every pair that is nearer than its two paths of
/// this step, with gap s and normal n as they are now,
///   (v_b - v_a).n >= -max(s, 0) / dt,
/// solved by sequential impulses, each pair's sum kept >= 0; then x += v dt, so that who was going to meet just touches.
/// Restitution comes last: a pair that got an impulse and came in at u_n < 0 leaves at -e u_n. Then overlaps are taken
/// back. A pair that would have passed side by side may be stopped by the plane between them: a ghost.
template <int D>
class Speculative {
 public:
  Speculative(const SpeculativeOptions& options, StepState<D>& s, bool every_pair)
      : solver_(options.solver),
        threshold_(std::ldexp(solver_.threshold, -s.world.units.velocity())),
        near_(every_pair),
        walls_(s.world.walls),
        book_(s.size()) {}

  void step(StepState<D>& s, const StepReport& report) {
    s.accelerate();
    find(s);
    for (int pass = 0; pass < solver_.iterations; ++pass)
      for (Constraint& c : constraints_) push_to(s, c, -std::max(c.gap, 0.0) / s.dt);
    s.move();
    ++s.steps;
    for (Constraint& c : constraints_)
      if (c.impulse > 0 && c.approach > 0) {
        const double e = restitution_at(c.restitution, c.approach, threshold_);
        if (e > 0) push_to(s, c, e * c.approach);
      }
    take_back_overlaps(s);
    note(s);
    report.all(book_.now());
    book_.turn();
  }

 private:
  using Vector = Vec<double, D>;

  struct Constraint {
    LastingContact<D> contact;
    Image<D> image;  // as the positions are stored
    Vector n;        // unit, from the partner to the ball
    Vector wall_velocity;
    double gap;          // [length unit] at the start of the step
    double approach;     // [length unit / L] before any impulse
    double restitution;  // [-]
    double mobility;     // [1 / mass unit] of the two together
    double impulse = 0;  // [momentum unit] >= 0
  };

  [[nodiscard]] static bool is_pair(const Constraint& c) { return c.contact.kind == EventKind::ball_ball; }

  /// Speed at which the two part along n.
  [[nodiscard]] static double parting(const StepState<D>& s, const Constraint& c) {
    const Vector& other = is_pair(c) ? s.v[c.contact.partner] : c.wall_velocity;
    return dot<double, D>(c.n, Vector(s.v[c.contact.ball] - other));
  }

  /// An impulse that makes them part at the speed `wanted`, as far as they only push.
  static void push_to(StepState<D>& s, Constraint& c, double wanted) {
    const double sum = std::max(c.impulse + (wanted - parting(s, c)) / c.mobility, 0.0);
    const Vector change = c.n * (sum - c.impulse);
    c.impulse = sum;
    s.v[c.contact.ball] += change * s.inverse_mass[c.contact.ball];
    if (is_pair(c)) s.v[c.contact.partner] -= change * s.inverse_mass[c.contact.partner];
  }

  void find(StepState<D>& s) {
    near_.ensure(s, 2 * s.fastest() * s.dt);
    constraints_.clear();
    path_.clear();
    for (const Vector& v : s.v) path_.push_back(std::sqrt(dot<double, D>(v, v)) * s.dt);
    if (!s.world.walls.empty())
      for (std::uint32_t i = 0; i < s.size(); ++i)
        if (!s.immovable(i)) find_walls(s, i);
    for (const auto& p : near_.pairs()) find_pair(s, p.i, p.j, p.image);
  }

  void find_walls(const StepState<D>& s, std::uint32_t i) {
    walls_.near(s.x[i], s.radius[i], s.since_start(), path_[i] + walls_.fastest() * s.dt, [&](const WallContact<D>& w) {
      const double e = s.world.restitution.at_wall(s.world.details[i].material, w.wall);
      add(s, {{EventKind::ball_wall, i, w.wall, w.feature}, {}, w.normal, w.velocity, w.gap, 0, e, s.inverse_mass[i]});
    });
  }
  void find_pair(const StepState<D>& s, std::uint32_t i, std::uint32_t j, const Image<D>& image) {
    const Vector r = s.separation(i, j, image);
    const double rr = dot<double, D>(r, r), sigma = s.radius[i] + s.radius[j], reach = sigma + path_[i] + path_[j];
    if (!(rr <= reach * reach) || rr == 0) return;
    const double distance = std::sqrt(rr);
    const double e = s.world.restitution.between(s.world.details[i].material, s.world.details[j].material);
    add(s, {{EventKind::ball_ball, i, j, 0, s.lasting_image(i, j, image)},
            image,
            Vector(r / -distance),
            Vector::Zero(),
            distance - sigma,
            0,
            e,
            s.inverse_mass[i] + s.inverse_mass[j]});
  }
  void add(const StepState<D>& s, Constraint c) {
    c.approach = -parting(s, c);
    constraints_.push_back(c);
  }

  void take_back_overlaps(StepState<D>& s) {
    if (solver_.correction == PositionCorrection::none) return;
    for (const Constraint& c : constraints_) {
      const std::uint32_t i = c.contact.ball, j = c.contact.partner;
      if (is_pair(c)) {
        const Vector r = s.separation(i, j, c.image);
        const double rr = dot<double, D>(r, r), sigma = s.radius[i] + s.radius[j];
        if (rr < sigma * sigma) push_apart(s, solver_, i, j, r, std::sqrt(rr));
      }
    }
    if (s.world.walls.empty()) return;
    for (std::uint32_t i = 0; i < s.size(); ++i)
      walls_.near(s.x[i], s.radius[i], s.since_start(), 0,
                  [&](const WallContact<D>& w) { push_out(s, solver_, i, -w.gap, w.normal); });
  }

  void note(const StepState<D>& s) {
    for (const Constraint& c : constraints_) {
      if (!(c.impulse > 0) && !(c.gap <= 0)) continue;
      LastingContact<D>& entry = book_.touch(c.contact, s.steps);
      entry.overlap = std::max(0.0, -c.gap);
      entry.impulse = c.impulse;
    }
  }

  SolverOptions solver_;
  double threshold_;  // [length unit / L]
  NearList<D> near_;
  WallContacts<D> walls_;
  ContactBook<D> book_;
  std::vector<double> path_;  // [length unit] of this step, by ball
  std::vector<Constraint> constraints_;
};

}  // namespace carom
