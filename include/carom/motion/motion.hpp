#pragma once
// What a motion is: position and velocity as functions of the time since the state was stored.

#include <concepts>

namespace carom {

/// Position, velocity and acceleration a time s >= 0 after the stored state (x, v); `fixed` balls stay where they are. The stored_
/// ones are what is written, and shown, at a change of motion: the same functions, rounded less often.
template <class M>
concept Motion = requires(const M& m, const typename M::Vector& x, const typename M::Real& s) {
  { m.position(x, x, false, s) } -> std::convertible_to<typename M::Vector>;
  { m.velocity(x, false, s) } -> std::convertible_to<typename M::Vector>;
  { m.stored_position(x, x, false, s) } -> std::convertible_to<typename M::Vector>;
  { m.stored_velocity(x, false, s) } -> std::convertible_to<typename M::Vector>;
  { m.acceleration(false) } -> std::convertible_to<typename M::Vector>;
  { M::accelerated } -> std::convertible_to<bool>;
};

}  // namespace carom
