#pragma once
// Continuous detection inside a step: the first contacts along the straight paths of the step, in order.

#include <algorithm>
#include <cmath>
#include <vector>

#include "carom/sim/fixed_step.hpp"
#include "carom/sim/fixed_step/near_list.hpp"
#include "carom/sim/fixed_step/step_report.hpp"
#include "carom/sim/fixed_step/sweep_times.hpp"

namespace carom {

/// v += a dt; then every ball flies straight for dt, and contacts happen at their closed-form times, each followed by a new
/// look at the two. A ball that has had as many as it may have (once: one) flies the rest of the step without looking, so
/// it may end inside another ball or beyond a wall; what overlaps and approaches at the start of a step meets at once.
template <int D>
class Swept {
 public:
  Swept(const SweptOptions& options, StepState<D>& s, bool every_pair)
      : limit_(options.sweep == Sweep::once ? 1 : options.limit),
        threshold_(std::ldexp(options.threshold, -s.world.units.velocity())),
        near_(every_pair),
        times_(s.size()),
        met_(s.size(), 0),
        book_(s.size()) {}

  void step(StepState<D>& s, const StepReport& report) {
    s.accelerate();
    if (s.world.accelerated()) times_.forget(s);
    times_.begin();
    if (near_.ensure(s, 2 * s.fastest() * s.dt)) near_.list_neighbours(s.size());
    std::fill(met_.begin(), met_.end(), 0);
    look_at_all(s);
    while (!queue_.empty()) {
      std::pop_heap(queue_.begin(), queue_.end(), later);
      const Meeting c = queue_.back();
      queue_.pop_back();
      if (overtaken(c)) continue;
      meet(s, c, report);
      look_again(s, c);
    }
    times_.fly_all(s, s.dt);
    ++s.steps;
    book_.turn();
  }

 private:
  using Meeting = SweptMeeting<D>;

  static bool later(const Meeting& a, const Meeting& b) { return a.after(b); }

  [[nodiscard]] bool looks(std::uint32_t i) const { return met_[i] < limit_; }
  [[nodiscard]] bool overtaken(const Meeting& c) const {
    return met_[c.ball] != c.ball_met || (c.kind == EventKind::ball_ball && met_[c.partner] != c.partner_met);
  }

  void add(Meeting c, const StepState<D>& s) {
    if (!(c.t <= s.dt)) return;
    c.ball_met = met_[c.ball];
    if (c.kind == EventKind::ball_ball) c.partner_met = met_[c.partner];
    queue_.push_back(c);
    std::push_heap(queue_.begin(), queue_.end(), later);
  }

  void look_at_all(const StepState<D>& s) {
    queue_.clear();
    for (std::uint32_t i = 0; i < s.size(); ++i) look_at_walls(s, i);
    for (const auto& p : near_.pairs()) look_at_pair(s, p.i, p.j, p.image);
  }
  void look_at_walls(const StepState<D>& s, std::uint32_t i) {
    if (looks(i)) times_.for_each_wall_meeting(s, i, [&](const Meeting& c) { add(c, s); });
  }
  void look_at_pair(const StepState<D>& s, std::uint32_t i, std::uint32_t j, const Image<D>& image) {
    if (looks(i) && looks(j)) add(times_.pair_meeting(s, std::min(i, j), std::max(i, j), i < j ? image : -image), s);
  }

  void look_again(StepState<D>& s, const Meeting& c) {
    const bool pair = c.kind == EventKind::ball_ball;
    if (!looks(c.ball) && !(pair && looks(c.partner))) return;
    const auto listed = [&](std::uint32_t i) {
      return near_.covers(i, s.x[i], std::sqrt(dot<double, D>(s.v[i], s.v[i])) * (s.dt - c.t));
    };
    if (!listed(c.ball) || (pair && !listed(c.partner))) {  // faster than when the list was made
      times_.fly_all(s, c.t);
      near_.make(s, 2 * s.fastest() * (s.dt - c.t));
      near_.list_neighbours(s.size());
      look_at_all(s);
      return;
    }
    look_from(s, c.ball);
    if (pair) look_from(s, c.partner);
  }
  void look_from(const StepState<D>& s, std::uint32_t i) {
    if (!looks(i)) return;
    look_at_walls(s, i);
    for (const auto& n : near_.neighbours(i)) look_at_pair(s, i, n.ball, n.image);
  }

  void meet(StepState<D>& s, const Meeting& c, const StepReport& report) {
    const SweptImpact impact = times_.meet(s, c, threshold_);
    ++met_[c.ball];
    if (c.kind == EventKind::ball_ball) ++met_[c.partner];
    LastingContact<D> found{c.kind, c.ball, c.partner, c.feature};
    if (c.kind == EventKind::ball_ball) found.image = s.lasting_image(c.ball, c.partner, c.image);
    LastingContact<D>& contact = book_.touch(found, s.steps);
    // `reported`: the impact before this one, at most a step ago, was without restitution.
    const bool rests = contact.reported && s.world.accelerated();
    contact.reported = impact.plastic && impact.impulse > 0;
    contact.overlap = impact.overlap;
    report.contact(contact, rests ? 0.0 : impact.impulse, report.time - std::ldexp(s.dt - c.t, report.units.time));
  }

  int limit_;
  double threshold_;  // [length unit / L]
  NearList<D> near_;
  SweepTimes<D> times_;
  std::vector<int> met_;        // contacts in this step, by ball: tells meetings that have been overtaken
  std::vector<Meeting> queue_;  // a heap, the first on top
  ContactBook<D> book_;
};

}  // namespace carom
