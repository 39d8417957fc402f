// A head-on hit on a corner at exactly 45 degrees: out of a concave corner the ball comes straight back after two hits; on
// the tip of a convex one it comes straight back after one.

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

TEST(CornerAt45Degrees, concave_made_of_anything) {
  const std::vector<std::vector<WallSpec>> corners = {{plane({0.0, 0.0}, {1.0, 0.0}), plane({0.0, 0.0}, {0.0, 1.0})},
                                                      {segment({0.0, 0.0}, {0.0, 9.0}), segment({9.0, 0.0}, {0.0, 0.0})},
                                                      {polygon({{0.0, 0.0}, {9.0, 0.0}, {9.0, 9.0}, {0.0, 9.0}})},
                                                      {polygon({{0.0, 9.0}, {9.0, 9.0}, {9.0, 0.0}, {0.0, 0.0}})},
                                                      {plane({0.0, 0.0}, {1.0, 0.0}), segment({0.0, 0.0}, {9.0, 0.0})}};
  for (std::size_t k = 0; k < corners.size(); ++k)
    for (const double radius : {0.5, 0.0, 0.3})
      for (const double speed : {1.0, 0.7}) {
        Scene scene = open_space(2);
        scene.walls = corners[k];
        scene.balls = {ball({3.0, 3.0}, {-speed, -speed}, radius)};
        const Result result = watched_run(scene, {.until = 4.0 / speed});
        EXPECT_EQ(result.balls[0].velocity, (std::vector<Number>{speed, speed})) << "corner " << k << " radius " << radius;
        // Two walls; or, for a point, the vertex that they share, which turns it round in one hit.
        EXPECT_LE(result.log.size(), 2u);
        EXPECT_EQ(result.summary.exactness.singular, result.log.size() == 1 ? 1 : 0);
        const double back = (3.0 - radius) / speed;
        EXPECT_NEAR(result.balls[0].position[0], radius + speed * (4.0 / speed - back), 1e-14);
        EXPECT_NEAR(result.balls[0].position[0], result.balls[0].position[1], 1e-15);
      }
}

TEST(CornerAt45Degrees, convex) {
  for (const double radius : {0.5, 0.0, 1e-9}) {
    Scene scene = open_space(2);
    scene.walls = {polygon({{0.0, 0.0}, {-2.0, 0.0}, {-2.0, -2.0}, {0.0, -2.0}})};
    scene.balls = {ball({3.0, 3.0}, {-1.0, -1.0}, radius)};
    const Result result = watched_run(scene, {.until = 10.0});
    ASSERT_EQ(result.log.size(), 1u);
    EXPECT_NEAR(result.log[0].time, 3.0 - radius / std::sqrt(2.0), 1e-15);
    EXPECT_NEAR(result.balls[0].velocity[0], 1.0, 4e-16);
    EXPECT_NEAR(result.balls[0].velocity[1], 1.0, 4e-16);
  }
}

// The corner of a moving box: in its frame all is as before.
TEST(CornerAt45Degrees, that_moves) {
  for (const double radius : {0.5, 0.0}) {
    Scene scene = open_space(2);
    scene.walls = {plane({0.0, 0.0}, {1.0, 0.0}), plane({0.0, 0.0}, {0.0, 1.0})};
    for (WallSpec& w : scene.walls) w.velocity = {0.5, 0.5};
    scene.balls = {ball({3.5, 3.5}, {-0.5, -0.5}, radius)};
    const Result result = watched_run(scene, {.until = 10.0});
    EXPECT_EQ(result.log.size(), 2u);
    EXPECT_EQ(result.balls[0].velocity, (std::vector<Number>{1.5, 1.5}));
    EXPECT_DOUBLE_EQ(result.summary.energy.injected, 0.5 * (4.5 - 0.5));
  }
}

}  // namespace
}  // namespace carom
