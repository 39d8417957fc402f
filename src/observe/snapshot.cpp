#include "carom/observe/snapshot.hpp"

#include <cmath>

namespace carom {

void look_at(const Simulation& simulation, Snapshot& balls) {
  balls.time = simulation.time();
  balls.ball_ball = simulation.counts().ball_ball;
  balls.position.clear();
  balls.velocity.clear();
  double twice = 0;
  const std::uint32_t count = simulation.ball_count();
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!simulation.alive(i)) continue;
    const Glimpse ball = simulation.glimpse(i);
    if (!std::isfinite(ball.mass)) continue;
    balls.position.push_back(ball.position);
    balls.velocity.push_back(ball.velocity);
    for (const double v : ball.velocity) twice += ball.mass * v * v;
  }
  balls.kinetic = twice / 2;
}

}  // namespace carom
