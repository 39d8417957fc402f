#pragma once
// The contacts of a step on their way to the sink, in the user's units.

#include <cmath>
#include <cstdint>

#include "carom/sim/fixed_step/contact_book.hpp"
#include "carom/sim/stepper.hpp"
#include "carom/world/units.hpp"

namespace carom {

struct StepReport {
  const StepSink& sink;
  const Units& units;
  std::int64_t step;  ///< this one, from 1
  double time;        ///< [time] of the scene's clock at its end

  template <int D>
  void contact(const LastingContact<D>& c, double impulse, double when) const {
    if (!sink) return;
    sink(StepContact{when, step, c.kind, c.ball, c.partner, c.feature, std::ldexp(c.overlap, units.length),
                     std::ldexp(impulse, units.momentum())});
  }

  /// Every contact of the step, as a collision where it is the first time that it got an impulse.
  template <int D>
  void all(std::vector<LastingContact<D>>& contacts) const {
    for (LastingContact<D>& c : contacts) {
      contact(c, c.reported ? 0.0 : c.impulse, time);
      c.reported = c.reported || c.impulse > 0;
    }
  }
};

}  // namespace carom
