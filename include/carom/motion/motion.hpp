#pragma once
// What a motion is: position and velocity as functions of the time since the state was stored.

#include <concepts>

namespace carom {

/// Position, velocity and acceleration a time s >= 0 after the stored state (x, v), in the phase that the ball is in: the
/// simplest motions know only `fixed`, a ball that stays where it is. The stored_ ones are what is written, and shown, at a
/// change of motion: the same functions, rounded less often. Balls in equal phases have the same acceleration; `circular`:
/// all turn at one frequency instead.
template <class M>
concept Motion = requires(const M& m, const typename M::Vector& x, const typename M::Real& s,
                          const typename M::Phase& phase) {
  { m.position(x, x, phase, s) } -> std::convertible_to<typename M::Vector>;
  { m.velocity(x, phase, s) } -> std::convertible_to<typename M::Vector>;
  { m.stored_position(x, x, phase, s) } -> std::convertible_to<typename M::Vector>;
  { m.stored_velocity(x, phase, s) } -> std::convertible_to<typename M::Vector>;
  { m.acceleration(phase) } -> std::convertible_to<typename M::Vector>;
  { M::accelerated } -> std::convertible_to<bool>;
  { M::can_rest } -> std::convertible_to<bool>;
  { M::circular } -> std::convertible_to<bool>;
};

}  // namespace carom
