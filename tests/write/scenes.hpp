#pragma once
// Small scenes, built in code.

#include "carom/scene/scene.hpp"

namespace carom::test {

/// Two elastic balls of radius 1/2 in a box [0, 10]^D. Along x they start at 3.5 and 6.5 with velocities 1 and -1: their
/// gap 2 - 2 t closes at t = 1, at x = 4.5 and 5.5; equal masses swap velocities, and at t = 5 they touch the faces at 0.5
/// and 9.5.
inline Scene head_on(int dimension) {
  Scene scene;
  scene.title = "Head-on";
  scene.dimension = dimension;
  scene.space.kind = SpaceKind::box;
  scene.space.lower = Coordinates(static_cast<std::size_t>(dimension), 0.0);
  scene.space.upper = Coordinates(static_cast<std::size_t>(dimension), 10.0);
  for (const double side : {-1.0, 1.0}) {
    BallSpec ball;
    ball.position = Coordinates(static_cast<std::size_t>(dimension), 5.0);
    ball.position[0] = 5.0 + 1.5 * side;
    ball.velocity = Coordinates(static_cast<std::size_t>(dimension), 0.0);
    ball.velocity[0] = -side;
    scene.balls.push_back(ball);
  }
  scene.balls[0].name = "left";
  scene.run.until = 6.0;
  return scene;
}

}  // namespace carom::test
