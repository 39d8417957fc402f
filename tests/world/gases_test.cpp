// Gases kept apart from the world, and joined to it.

#include "carom/world/gases.hpp"

#include <gtest/gtest.h>

#include "carom/scene/read.hpp"
#include "carom/world/build.hpp"
#include "carom/world/near_pairs.hpp"

namespace carom {
namespace {

/// A ball, a lattice and two gases in a cell that is no power of two wide: numbers 0, 1..4, 5..204, 205..304.
Scene mixture() {
  return read_scene(R"(
dimension = 2
space = { kind = "periodic", lower = [-3.1, 0.7], upper = [20.3, 24.1] }
run = { until = 1 }
[[gas]]
count = 200
radius = 0.37
mass = 2.5
[[gas]]
count = 100
radius = 0.11
temperature = 4
[[ball]]
position = [0.1, 1.3]
velocity = [0.5, 0]
radius = 0.3
[[lattice]]
kind = "square"
count = 4
radius = 0.9
)",
                    "scene.toml");
}

TEST(Gases, lie_apart_until_they_are_joined) {
  const auto parts = build_apart<2>(mixture());
  ASSERT_EQ(parts.world.balls.size(), 5u);
  ASSERT_EQ(parts.gases.size(), 2u);
  EXPECT_EQ(parts.gases[0].position.size(), 400u);
  EXPECT_EQ(parts.gases[1].velocity.size(), 200u);
  EXPECT_EQ(parts.size(), 305u);
}

TEST(Gases, joined_are_the_world_that_build_makes) {
  const auto whole = build<double, 2>(mixture());
  const auto joined = join(build_apart<2>(mixture()));
  ASSERT_EQ(whole.balls.size(), 305u);
  ASSERT_EQ(joined.balls.size(), 305u);
  for (std::size_t i = 0; i < whole.balls.size(); ++i) {
    EXPECT_EQ(whole.balls[i].position, joined.balls[i].position);
    EXPECT_EQ(whole.balls[i].velocity, joined.balls[i].velocity);
    EXPECT_EQ(whole.balls[i].radius, joined.balls[i].radius);
    EXPECT_EQ(whole.details[i].mass, joined.details[i].mass);
  }
  EXPECT_EQ(std::ldexp(whole.details[5].mass, whole.units.mass), 2.5);
}

// Nobody judges how a gas starts; so its balls must be clear of each other and of all else: |r| > sum of radii.
TEST(Gases, touch_nothing_at_the_start) {
  const auto world = build<double, 2>(mixture());
  std::vector<Vec<double, 2>> positions;
  for (const auto& b : world.balls) positions.push_back(b.position);
  int pairs = 0;
  for_each_near_pair(world, positions, 0.0, [&](std::uint32_t i, std::uint32_t j, const Image<2>& image) {
    double rr = 0;
    for (int k = 0; k < 2; ++k) {
      const double r = positions[j][k] + image[k] * world.space.edge[k] - positions[i][k];
      rr += r * r;
    }
    const double contact = world.balls[i].radius + world.balls[j].radius;
    EXPECT_GT(rr, contact * contact * (1 + 0x1p-40)) << i << " and " << j;
    ++pairs;
  });
  EXPECT_GT(pairs, 300);
  for (std::size_t i = 5; i < world.balls.size(); ++i) EXPECT_FALSE(world.balls[i].in_contact);
}

}  // namespace
}  // namespace carom
