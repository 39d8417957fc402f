#pragma once
// When a ball slides off the end of the flat wall that it rests on.

#include "carom/motion/motion.hpp"
#include "carom/predict/event.hpp"
#include "carom/solve/gap.hpp"
#include "carom/world/flat_walls.hpp"

namespace carom {

/// Whether `shape` is an end of the segment that the ball is held to: it is met only once the ball has left.
template <class Real, int D, class Shape>
[[nodiscard]] inline bool is_end_of_rest(const World<Real, D>& world, const Ball<Real, D>& ball, const Shape& shape) {
  bool end = false;
  if constexpr (D == 2 && std::is_same_v<Shape, Sphere<Real, D>>)
    with_flat(world.walls, ball.held, [&](const auto& flat) {
      if constexpr (std::is_same_v<std::remove_cvref_t<decltype(flat)>, Segment<Real>>)
        end = shape.radius == 0 && shape.wall == flat.wall && (shape.centre == flat.from || shape.centre == flat.to);
    });
  return end;
}

/// Ball i rests on `shape`. Faces and planes have no end; over a segment the height of the ball's centre over each end,
/// measured along the segment, is a parabola.
template <Motion M, class Shape>
[[nodiscard]] inline Event<typename M::Real, M::dimension> predict_leaving(
    const M& motion, const World<typename M::Real, M::dimension>& world, std::uint32_t i, const Shape& shape) {
  using Real = typename M::Real;
  constexpr int D = M::dimension;
  Event<Real, D> event;
  if constexpr (std::is_same_v<Shape, Segment<Real>> && D == 2) {
    const Ball<Real, D>& ball = world.balls[i];
    const Vec<Real, D> x = ball.position - shape.velocity * elapsed(world.start, ball.time);
    const Real rate = dot<Real, D>(shape.along, ball.velocity - shape.velocity);
    const Real half = dot<Real, D>(shape.along, motion.acceleration(motion.phase(ball))) / 2;
    const Real back = first_fall(dot<Real, D>(shape.along, x - shape.from), rate, half);
    const Real on = first_fall(dot<Real, D>(shape.along, shape.to - x), Real(-rate), Real(-half));
    const Real flight = back < on ? back : on;
    if (flight == never<Real>()) return event;
    event.time = after(ball.time, flight);
    if (event.time.is_never()) return event;
    event.kind = EventKind::motion_change;
    event.ball = i;
    event.partner = index(shape.wall);
    event.feature = shape.feature;
    event.stamp = ball.stamp;
  }
  return event;
}

}  // namespace carom
