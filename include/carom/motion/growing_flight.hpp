#pragma once
// Free flight of balls whose radii grow at constant rates.

#include "carom/motion/free_flight.hpp"
#include "carom/motion/motion.hpp"

namespace carom {

/// Paths are those of free flight; the world knows the rates (world/growth.hpp).
template <class RealType, int Dimension>
struct GrowingFlight : FreeFlight<RealType, Dimension> {
  static constexpr bool grows = true;
  static constexpr const char* name = "free flight of growing balls";
};

/// A motion under which radii grow: what meets is decided by the constrained overloads of predict/growing.hpp.
template <class M>
concept GrowingMotion = Motion<M> && requires {
  requires M::grows;
};

}  // namespace carom
