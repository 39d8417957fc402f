#pragma once
// What an observer is.

#include <concepts>

#include "carom/observe/estimate.hpp"
#include "carom/observe/flight.hpp"
#include "carom/observe/subject.hpp"
#include "carom/sim/simulation.hpp"

namespace carom {

/// Is made when measuring begins, from the subject as it is then; is told of every collision, at `t` since measuring began
/// and with the subject as it was before it, and of the end; yields estimates.
template <class O>
concept Observer = requires(O o, const O& done, const Collision& c, double t, const Subject& subject) {
  o.collision(c, t, subject);
  o.end(t);
  { done.estimates() } -> std::same_as<Estimates>;
};

/// Is also told of every flight: each that ended in a collision just before that collision, the unfinished ones before the
/// end.
template <class O>
concept FlightObserver = Observer<O> && requires(O o, const Flight& flight) {
  o.flight(flight);
};

}  // namespace carom
