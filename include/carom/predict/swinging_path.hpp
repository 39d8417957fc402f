#pragma once
// The path of a ball as seen from a wall that swings or moves, with bounds of how sharply it bends.

#include <cmath>

#include "carom/motion/motion.hpp"
#include "carom/world/wall_motion.hpp"

namespace carom {

/// Beside it the middle of the path: as seen from the middle of the swing, and in a field the centre of the ball's circles.
template <Motion M>
class SwingingPath {
 public:
  using Real = typename M::Real;
  static constexpr int D = M::dimension;
  using Vector = Vec<Real, D>;

  SwingingPath(const M& motion, const World<Real, D>& world, const Ball<Real, D>& ball, const Vector& wall_velocity,
               const Swing<Real, D>& swing)
      : motion_(motion),
        swing_(swing),
        phase_(motion.phase(ball)),
        angle_(swing.angle(ball.time)),
        middle_(ball.position - wall_velocity * elapsed(world.start, ball.time)),
        own_velocity_(ball.velocity),
        wall_velocity_(wall_velocity) {
    using std::sin;
    using std::sqrt;
    start_ = middle_ - swing.amplitude * Real(sin(angle_));
    const Vector a = acceleration();
    const Real size = sqrt(dot<Real, D>(swing.amplitude, swing.amplitude)), w = swing.omega;
    bend_ = sqrt(dot<Real, D>(a, a)) + size * w * w;
    jerk_ = size * w * w * w;
    snap_ = jerk_ * w;
    if constexpr (M::circular) {
      const Real turning = motion.speed(), v = sqrt(dot<Real, D>(ball.velocity, ball.velocity));
      circle_ = v / turning;
      middle_ += motion.turned(ball.velocity) / turning;
      bend_ += v * turning;
      jerk_ += v * turning * turning;
      snap_ += v * turning * turning * turning;
    }
    reach_ = size + circle_;
  }

  /// From the wall, s after the stored state: where the wall stands still, with its own coordinates.
  [[nodiscard]] Vector position(const Real& s) const {
    using std::cos;
    using std::sin;
    const Real half = swing_.omega * s / 2;
    const Real swung = 2 * Real(cos(angle_ + half)) * Real(sin(half));  // sin(angle + omega s) - sin(angle)
    return start_ + own_displacement(s) - wall_velocity_ * s - swing_.amplitude * swung;
  }
  [[nodiscard]] Vector velocity(const Real& s) const {
    using std::cos;
    return motion_.velocity(own_velocity_, phase_, s) - wall_velocity_ -
           swing_.amplitude * Real(swing_.omega * cos(angle_ + swing_.omega * s));
  }
  [[nodiscard]] Vector middle(const Real& s) const {
    if constexpr (M::circular) return middle_ - wall_velocity_ * s;
    return middle_ + own_displacement(s) - wall_velocity_ * s;
  }
  [[nodiscard]] Vector middle_velocity(const Real& s) const {
    if constexpr (M::circular) return -wall_velocity_;
    return motion_.velocity(own_velocity_, phase_, s) - wall_velocity_;
  }
  /// Of the middle.
  [[nodiscard]] Vector acceleration() const { return motion_.acceleration(phase_); }
  /// At the stored time, as seen from the wall.
  [[nodiscard]] Vector acceleration_now() const {
    using std::sin;
    Vector now = acceleration() + swing_.amplitude * Real(swing_.omega * swing_.omega * sin(angle_));
    if constexpr (M::circular) now += motion_.turned(own_velocity_) * motion_.speed();
    return now;
  }
  [[nodiscard]] Vector jerk_now() const {
    using std::cos;
    Vector now = swing_.amplitude * Real(swing_.omega * swing_.omega * swing_.omega * cos(angle_));
    if constexpr (M::circular) now -= own_velocity_ * Real(motion_.speed() * motion_.speed());
    return now;
  }

  /// How far the ball may be from the middle, and the largest size of the first derivatives of its velocity.
  [[nodiscard]] const Real& reach() const { return reach_; }
  [[nodiscard]] const Real& bend() const { return bend_; }
  [[nodiscard]] const Real& jerk() const { return jerk_; }
  [[nodiscard]] const Real& snap() const { return snap_; }
  /// The same in the direction n only.
  [[nodiscard]] Real reach_along(const Vector& n) const { return across(n) + circle_; }
  [[nodiscard]] Real bend_along(const Vector& n) const {
    using std::abs;
    Real bend = abs(dot<Real, D>(n, acceleration())) + across(n) * swing_.omega * swing_.omega;
    if constexpr (M::circular) bend += circle_ * motion_.speed() * motion_.speed();
    return bend;
  }
  /// Largest speed that the swing and the circles make.
  [[nodiscard]] Real shaking() const {
    using std::sqrt;
    Real speed = sqrt(dot<Real, D>(swing_.amplitude, swing_.amplitude)) * swing_.omega;
    if constexpr (M::circular) speed += circle_ * motion_.speed();
    return speed;
  }
  /// After so long everything is as it was, if the middle rests.
  [[nodiscard]] Real period() const {
    using std::atan;
    if constexpr (M::circular) return 8 * atan(Real(1)) / motion_.speed();
    return 8 * atan(Real(1)) / swing_.omega;
  }

 private:
  [[nodiscard]] Vector own_displacement(const Real& s) const {
    return motion_.position(Vector::Zero(), own_velocity_, phase_, s);
  }
  [[nodiscard]] Real across(const Vector& n) const {
    using std::abs;
    return abs(dot<Real, D>(n, swing_.amplitude));
  }

  const M& motion_;
  const Swing<Real, D>& swing_;
  typename M::Phase phase_;
  Real angle_;
  Vector middle_, own_velocity_, wall_velocity_, start_;
  Real bend_, jerk_, snap_, reach_, circle_ = Real(0);
};

}  // namespace carom
