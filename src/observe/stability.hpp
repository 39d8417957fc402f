#pragma once
// How stable a periodic orbit is: the eigenvalues of its return map across it.

#include "carom/observe/periodic_orbit.hpp"
#include "dense.hpp"

namespace carom {

/// Fills multipliers, trace and kind. `monodromy` is the derivative of the state after one period by the state before,
/// `flow` its rate of change and `gradient` that of the energy. Flow and energy are left out: the map is taken on the
/// states of equal energy, and there across the flow, on which it acts as a matrix without their eigenvalues 1.
/// `certain`: a difference below it cannot be told from 0.
void judge_stability(const Dense& monodromy, const Multis& flow, const Multis& gradient, const Multi& certain, PeriodicOrbit& orbit);

}  // namespace carom
