#include "carom/observe/frame.hpp"

#include <cmath>

namespace carom {

void look_at(const Simulation& simulation, Frame& frame) {
  frame.time = simulation.time();
  frame.ball_ball = simulation.counts().ball_ball;
  frame.position.clear();
  frame.velocity.clear();
  double twice = 0;
  const std::uint32_t count = simulation.ball_count();
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!simulation.alive(i)) continue;
    const Glimpse ball = simulation.glimpse(i);
    if (!std::isfinite(ball.mass)) continue;
    frame.position.push_back(ball.position);
    frame.velocity.push_back(ball.velocity);
    for (const double v : ball.velocity) twice += ball.mass * v * v;
  }
  frame.kinetic = twice / 2;
}

}  // namespace carom
