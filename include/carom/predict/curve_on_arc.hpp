#pragma once
// When a ball on a circular path meets an ellipse, a parabola or a curve r(theta) at rest: by bounds.

#include "carom/predict/ball_curve.hpp"
#include "carom/predict/contact.hpp"
#include "carom/predict/sided.hpp"
#include "carom/predict/traced_path.hpp"
#include "carom/shape/curved.hpp"
#include "carom/world/world.hpp"

namespace carom {

/// The angles of path and curve are those of sine and cosine of the machine's own library.
template <class M, class Curve>
requires is_curved<Curve>
[[nodiscard]] inline SidedFlight<typename M::Real> flight_on_arc(const M& motion, const Ball<typename M::Real, 2>& ball,
                                                                 const Curve& curve, const Contact<2>* contact) {
  using Real = typename M::Real;
  const CircularPath<M> path{motion, Vec<Real, 2>(ball.position - curve.centre), ball.velocity};
  const Touch touch = touch_of_wall(contact, ball);
  if constexpr (requires { curve.home(); }) {
    return {detail::traced_flight<Real>(curve, path, ball.radius, touch, curve.home()).flight, curve.home()};
  } else {
    return detail::traced_flight<Real>(curve, path, ball.radius, touch, contact != nullptr ? contact->side : std::int8_t(0));
  }
}

}  // namespace carom
