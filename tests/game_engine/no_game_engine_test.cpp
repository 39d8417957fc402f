// A carom that was built without game engines.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "carom/core/error.hpp"
#include "carom/game_engine/game_engine.hpp"
#include "carom/scene/read.hpp"

namespace carom {
namespace {

using testing::AllOf;
using testing::HasSubstr;

Scene one_ball() { return read_scene("run.until = 1\n[[ball]]\nposition = [0, 0]\n", "scene.toml"); }

TEST(NoGameEngine, names_the_package_that_is_missing) {
  for (const GameEngine& engine : game_engines()) {
    EXPECT_FALSE(engine.built);
    GameEngineOptions options = parse_game_engine(engine.name);
    options.dt = 0.01;
    try {
      (void)make_game_engine(one_ball(), options);
      FAIL() << engine.name;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), AllOf(HasSubstr(engine.package), HasSubstr("is not in this carom")));
    }
  }
}

TEST(NoGameEngine, says_all_the_same_what_an_engine_does_not_have) {
  EXPECT_FALSE(cannot_represent(one_ball(), "bullet").empty());
  EXPECT_TRUE(refuses(one_ball(), "bullet").empty());
}

}  // namespace
}  // namespace carom
