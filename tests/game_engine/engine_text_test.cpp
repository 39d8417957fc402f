#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "carom/core/error.hpp"
#include "carom/game_engine/game_engine.hpp"

namespace carom {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string refusal_of(const std::string& text) {
  try {
    (void)parse_game_engine(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(EngineText, comes_back_as_it_was_written) {
  for (const std::string text : {"box2d", "box2d:continuous", "bullet:continuous:awake", "chipmunk", "chipmunk:awake",
                                 "box2d:threshold=0", "bullet:continuous:awake:threshold=0.125"})
    EXPECT_EQ(game_engine_text(parse_game_engine(text)), text);
  EXPECT_EQ(game_engine_text(parse_game_engine("box2d:threshold=1e-1:awake")), "box2d:awake:threshold=0.1");
}

TEST(EngineText, holds_every_option) {
  const GameEngineOptions options = parse_game_engine("bullet:threshold=0.5:awake:continuous");
  EXPECT_EQ(options, (GameEngineOptions{"bullet", 0.0, true, true, 0.5}));
}

TEST(EngineText, names_the_known_engines) {
  for (const std::string text : {"havok", "", "Box2D", "box2d "})
    EXPECT_THAT(refusal_of(text), AllOf(HasSubstr('"' + text + '"'), HasSubstr("box2d, chipmunk, bullet"))) << text;
}

TEST(EngineText, names_the_options_that_an_engine_has) {
  EXPECT_THAT(refusal_of("box2d:fast"), AllOf(HasSubstr("\"fast\""), HasSubstr("continuous, awake, threshold=V")));
  EXPECT_THAT(refusal_of("chipmunk:continuous"), HasSubstr("the options of Chipmunk are awake"));
  EXPECT_THAT(refusal_of("chipmunk:threshold=1"), HasSubstr("the options of Chipmunk are awake"));
  for (const std::string text : {"box2d:", "box2d::awake", "box2d:awake:", "box2d:awake=1", "box2d:threshold"})
    EXPECT_THAT(refusal_of(text), HasSubstr("the options of Box2D are")) << text;
}

TEST(EngineText, lists_all_that_is_wrong) {
  const std::string all = refusal_of("bullet:threshold=slow:threshold=-1:loud");
  EXPECT_THAT(all, AllOf(HasSubstr("is a number"), HasSubstr("at least 0"), HasSubstr("\"loud\"")));
  EXPECT_THAT(refusal_of("bullet:threshold=inf"), HasSubstr("at least 0"));
}

TEST(GameEngines, are_listed_with_their_packages) {
  const auto& all = game_engines();
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].package, "libbox2d-dev");
  EXPECT_EQ(all[1].package, "libchipmunk-dev");
  EXPECT_EQ(all[2].package, "libbullet-dev");
  for (const GameEngine& e : all) {
    EXPECT_EQ(e.version.empty(), !e.built) << e.name;
    EXPECT_FALSE(e.settings.empty()) << e.name;
  }
}

}  // namespace
}  // namespace carom
