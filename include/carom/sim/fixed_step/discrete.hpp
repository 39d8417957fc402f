#pragma once
// The discrete loop of game programming: move everything, look what overlaps, push.

#include <cmath>

#include "carom/sim/fixed_step/contact_book.hpp"
#include "carom/sim/fixed_step/correction.hpp"
#include "carom/sim/fixed_step/near_list.hpp"
#include "carom/sim/fixed_step/step_report.hpp"
#include "carom/sim/fixed_step/wall_contacts.hpp"

namespace carom {

/// v += a dt, x += v dt; then, in each pass, for every pair with |x2 - x1| <= r1 + r2: the normal along the centres; if
/// they approach, an impulse along it, with restitution; and the overlap, or a part of it, is taken back, shared by inverse
/// mass. Pairs are taken one after the other, walls first, and each sees what those before it have done.
template <int D>
class Discrete {
 public:
  Discrete(const DiscreteOptions& options, StepState<D>& s, bool every_pair)
      : solver_(options.solver),
        threshold_(std::ldexp(solver_.threshold, -s.world.units.velocity())),
        near_(every_pair),
        walls_(s.world.walls),
        book_(s.size()) {}

  void step(StepState<D>& s, const StepReport& report) {
    s.accelerate();
    s.move();
    ++s.steps;
    for (LastingContact<D>& c : book_.before()) c.impulse = c.overlap = 0;
    for (int pass = 0; pass < solver_.iterations; ++pass) {
      acted_ = false;
      push_walls(s);
      find_overlaps(s);
      push_balls(s);
      if (!acted_) break;
    }
    report.all(book_.now());
    book_.turn();
  }

 private:
  using Contact = LastingContact<D>;

  void push_walls(StepState<D>& s) {
    if (s.world.walls.empty()) return;
    for (std::uint32_t i = 0; i < s.size(); ++i) {
      if (s.immovable(i)) continue;
      walls_.near(s.x[i], s.radius[i], s.since_start(), 0, [&](const WallContact<D>& w) {
        const double impulse = collide_wall(s, i, w.wall, w.normal, w.velocity, threshold_).impulse;
        const bool moved = push_out(s, solver_, i, -w.gap, w.normal);
        acted_ = acted_ || impulse > 0 || moved;
        note(Contact{EventKind::ball_wall, i, w.wall, w.feature}, -w.gap, impulse, s.steps);
      });
    }
  }

  void find_overlaps(StepState<D>& s) {
    near_.ensure(s, 0);
    overlapping_.clear();
    for (const auto& p : near_.pairs()) {
      const Vec<double, D> r = s.separation(p.i, p.j, p.image);
      const double sigma = s.radius[p.i] + s.radius[p.j];
      if (dot<double, D>(r, r) <= sigma * sigma) overlapping_.push_back(p);
    }
  }

  void push_balls(StepState<D>& s) {
    for (const auto& p : overlapping_) {
      const Vec<double, D> r = s.separation(p.i, p.j, p.image);
      const double rr = dot<double, D>(r, r), sigma = s.radius[p.i] + s.radius[p.j];
      if (!(rr <= sigma * sigma)) continue;  // taken apart by one before it
      const double impulse = collide_balls(s, p.i, p.j, r, threshold_).impulse;
      const double distance = std::sqrt(rr);
      const bool moved = push_apart(s, solver_, p.i, p.j, r, distance);
      acted_ = acted_ || impulse > 0 || moved;
      note(Contact{EventKind::ball_ball, p.i, p.j, 0, s.lasting_image(p.i, p.j, p.image)}, sigma - distance, impulse,
           s.steps);
    }
  }

  void note(const Contact& found, double overlap, double impulse, std::int64_t step) {
    Contact& c = book_.touch(found, step);
    c.overlap = std::max(c.overlap, overlap);
    c.impulse += impulse;
  }

  SolverOptions solver_;
  double threshold_;  // [length unit / L]
  NearList<D> near_;
  std::vector<typename NearList<D>::Pair> overlapping_;
  WallContacts<D> walls_;
  ContactBook<D> book_;
  bool acted_ = false;
};

}  // namespace carom
