// Row 17: no friction at all is the default. Nothing acts across the normal: tangential velocities stay to the bit where
// the normal is along an axis, speeds do not decay, and a ball alone flies for ever.

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

TEST(Frictionless, is_the_default) {
  Scene scene = box({0.0, 0.0, 0.0}, {7.0, 9.0, 11.0});
  scene.balls = {ball({1.0, 2.0, 3.0}, {0.1, 0.7, -0.3})};
  const Result result = watched_run(scene, {.events = 5000, .stride = 77});
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_EQ(std::abs(result.balls[0].velocity[k]), std::abs(scene.balls[0].velocity[k].value));
  EXPECT_EQ(result.summary.energy.relative_error, 0.0);
  EXPECT_EQ(result.summary.energy.dissipated, 0.0);
}

// Inelastic walls take from the normal velocity alone.
TEST(Frictionless, whatever_the_restitution) {
  Scene scene = open_space(2);
  scene.collision.restitution = 0.25;
  scene.walls = {plane({0.0, 0.0}, {0.0, 1.0})};
  scene.balls = {ball({0.0, 3.5}, {1.0 / 3.0, -1.0})};
  const Result result = watched_run(scene, {.until = 10.0});
  ASSERT_EQ(result.log.size(), 1u);
  EXPECT_EQ(result.balls[0].velocity, (std::vector<Number>{1.0 / 3.0, 0.25}));
}

}  // namespace
}  // namespace carom
