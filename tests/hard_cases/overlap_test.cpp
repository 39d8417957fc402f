// Row 9: an initial overlap is refused with the pair and its depth, once it is more than rounding; nothing is moved apart
// silently. Two balls, boxes and walls are in tests/world/world_build_test.cpp (Refused); here: 3-D, periodic images, ends
// of segments, and that every pair of a heap is named.

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

bool mentions(const std::vector<std::string>& texts, const std::string& part) {
  for (const std::string& text : texts)
    if (text.find(part) != std::string::npos) return true;
  return false;
}

TEST(Overlap, of_each_pair_of_a_heap_is_named) {
  Scene scene = open_space(3);
  for (int i = 0; i < 4; ++i) scene.balls.push_back(ball({0.25 * i, 0.0, 0.0}, {}));
  const auto texts = refusals(scene);
  EXPECT_EQ(texts.size(), 6u);
  EXPECT_TRUE(mentions(texts, "ball 0 and ball 3 overlap by 0.25"));
  EXPECT_TRUE(mentions(texts, "ball 1 and ball 2 overlap by 0.75"));
}

TEST(Overlap, through_a_period) {
  Scene scene = open_space(2);
  scene.space.kind = SpaceKind::periodic;
  scene.space.lower = {0.0, 0.0};
  scene.space.upper = {10.0, 10.0};
  scene.balls = {ball({0.25, 5.0}, {}), ball({9.5, 5.0}, {})};
  EXPECT_TRUE(mentions(refusals(scene), "ball 0 and ball 1 overlap by 0.25"));
  scene.balls = {ball({5.0, 5.0}, {}, 5.5)};
  EXPECT_TRUE(mentions(refusals(scene), "its own periodic image"));
}

TEST(Overlap, with_an_end_of_a_segment) {
  Scene scene = open_space(2);
  scene.walls = {segment({0.0, 0.0}, {0.0, -4.0})};
  scene.balls = {ball({0.0, 0.25}, {})};
  EXPECT_EQ(refusals(scene).size(), 1u);
  scene.balls = {ball({0.0, 0.5}, {})};
  EXPECT_TRUE(refusals(scene).empty()) << "touches it";
  scene.balls = {ball({0.0, 0.5 - 0x1p-49}, {})};
  EXPECT_EQ(refusals(scene).size(), 1u) << "by four ulps";
}

// Concentric balls, and a small one inside a large one.
TEST(Overlap, however_deep) {
  Scene scene = open_space(2);
  scene.balls = {ball({1.0, 1.0}, {}), ball({1.0, 1.0}, {})};
  EXPECT_TRUE(mentions(refusals(scene), "overlap by 1 "));
  scene.balls = {ball({0.0, 0.0}, {}, 10.0), ball({1.0, 0.0}, {1.0, 0.0}, 0.5)};
  EXPECT_TRUE(mentions(refusals(scene), "overlap by 9.5 "));
}

}  // namespace
}  // namespace carom
