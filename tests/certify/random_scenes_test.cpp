// On random scenes the double run's log is the proven one up to the horizon that `check` names.
//
// Fifty scenes here. CAROM_CERTIFY_SCENES=1000 in the environment takes a thousand [papers/certify/README.md].

#include <cstdlib>

#include <gtest/gtest.h>

#include "carom/observe/horizon.hpp"
#include "certify/scenes.hpp"

namespace carom {
namespace {

using namespace testing;
using certify::Report;
using certify::Verdict;

constexpr std::int64_t events = 60;

/// Three to five balls in a box or a period, of one to three dimensions; with gravity, losses, or neither.
Scene random_scene(std::uint64_t seed) {
  Dice dice(seed);
  const int dimension = 1 + static_cast<int>(dice.between(0.0, 3.0)), balls = 3 + static_cast<int>(dice.between(0.0, 3.0));
  Scene scene = mixed_box(dimension, balls, 4.0, seed);
  const double kind = dice.unit();
  if (kind < 0.3) scene.space.kind = SpaceKind::periodic;
  if (kind > 0.6) scene.collision.restitution = Number(dice.between(0.7, 1.0));
  if (kind > 0.8) {
    scene.motion.acceleration.assign(static_cast<std::size_t>(dimension), Number(0.0));
    scene.motion.acceleration.back() = Number(-dice.between(0.1, 1.0));
  }
  scene.run.events = events;
  return scene;
}

TEST(RandomScenes, double_runs_are_right_up_to_their_horizon) {
  const char* const asked = std::getenv("CAROM_CERTIFY_SCENES");
  const int scenes = asked != nullptr ? std::atoi(asked) : 50;
  int proven = 0, left = 0;
  for (int seed = 1; seed <= scenes; ++seed) {
    const Scene scene = random_scene(static_cast<std::uint64_t>(seed));
    const Report report = certify::prove(scene, {50, 800});
    ASSERT_EQ(report.verdict, Verdict::proven) << "seed " << seed << ", event " << report.at_event << ": " << report.what;
    ++proven;
    const Horizon horizon = find_horizon(scene, {.digits = 200, .collisions = events});
    ASSERT_TRUE(report.against_double);
    const auto& different = report.against_double->different;
    ASSERT_EQ(different.has_value(), horizon.partner.has_value()) << "seed " << seed;
    if (!different) continue;
    ++left;
    EXPECT_EQ(different->event, horizon.partner->event) << "seed " << seed;
  }
  EXPECT_EQ(proven, scenes);
  EXPECT_GT(left, 0) << "some are chaotic enough";
}

}  // namespace
}  // namespace carom
