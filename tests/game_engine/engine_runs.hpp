#pragma once
// Scenes put into every engine that is built, stepped, and what came out.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "carom/game_engine/game_engine.hpp"
#include "carom/scene/read.hpp"

namespace carom::test {

struct EngineRun {
  std::vector<StepContact> contacts{};    ///< all that were reported
  std::vector<StepContact> collisions{};  ///< those with an impulse
  std::vector<BallState> balls{};         ///< at the end
  double time = 0.0;
};

inline Scene scene_of(std::string_view text) { return read_scene(text, "scene.toml"); }

/// `engine` is a text such as "box2d:continuous".
inline EngineRun run_engine(std::string_view engine, std::string_view scene, double dt, int steps) {
  GameEngineOptions options = parse_game_engine(engine);
  options.dt = dt;
  const auto stepper = make_game_engine(scene_of(scene), options);
  EngineRun run;
  for (int k = 0; k < steps; ++k)
    stepper->step([&](const StepContact& c) {
      run.contacts.push_back(c);
      if (c.impulse > 0) run.collisions.push_back(c);
    });
  run.balls = stepper->balls();
  run.time = stepper->time();
  return run;
}

inline std::vector<double> doubles(const auto& numbers) { return {numbers.begin(), numbers.end()}; }

inline bool built(std::string_view name) {
  for (const GameEngine& e : game_engines())
    if (e.name == name) return e.built;
  return false;
}

/// Names of the engines that are built.
inline std::vector<std::string> built_engines() {
  std::vector<std::string> names;
  for (const GameEngine& e : game_engines())
    if (e.built) names.push_back(e.name);
  return names;
}

class EachEngine : public testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] const std::string& engine() const { return GetParam(); }
  /// With what it needs to give every impact its restitution and to keep what is slow awake.
  [[nodiscard]] std::string keen_engine() const {
    return engine() == "chipmunk" ? engine() : engine() + ":awake:threshold=0";
  }
};

}  // namespace carom::test

#define CAROM_SKIP_UNLESS_BUILT(name) \
  if (!carom::test::built(name)) GTEST_SKIP() << name << " is not built"
