// Logs kept as text: the same bits from every compiler, at every level of optimisation, on every day.
//
// A line is a collision: epoch, offset [user's time], kind, ball, partner, the velocity of the ball after it and, for a
// ball, that of the partner; numbers that are not counts are hexadecimal. To write the files anew (a change of their
// content is a commit of its own, with its reason): CAROM_REGENERATE_GOLDEN=1 ./golden_tests

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "sim/scenes.hpp"

namespace carom {
namespace {

using namespace testing;

std::string hex(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%a", x);
  return text;
}

std::string line(const Collision& c, int dimension) {
  const bool pair = c.kind == EventKind::ball_ball;
  std::string text = std::to_string(c.epoch) + " " + hex(c.offset) + (pair ? " ball_ball " : " ball_wall ") +
                     std::to_string(c.ball.number) + " " + std::to_string(c.partner.number);
  for (int k = 0; k < dimension; ++k) text += " " + hex(c.ball.velocity_after[std::size_t(k)]);
  if (pair)
    for (int k = 0; k < dimension; ++k) text += " " + hex(c.partner.velocity_after[std::size_t(k)]);
  return text;
}

void expect_golden(const std::string& name, const Scene& scene, std::int64_t events) {
  const std::string path = std::string(CAROM_GOLDEN_DIR) + "/" + name + ".log";
  std::vector<std::string> lines;
  for (const Collision& c : run(scene, events).log) lines.push_back(line(c, scene.dimension));
  if (std::getenv("CAROM_REGENERATE_GOLDEN") != nullptr) {
    std::ofstream out(path);
    for (const std::string& l : lines) out << l << '\n';
    ASSERT_TRUE(out.good()) << path;
    return;
  }
  std::ifstream in(path);
  ASSERT_TRUE(in.good()) << path << " is missing";
  std::size_t i = 0;
  for (std::string expected; std::getline(in, expected); ++i) {
    ASSERT_LT(i, lines.size()) << name << ": the run is shorter than the golden log";
    ASSERT_EQ(lines[i], expected) << name << ": collision " << i;
  }
  EXPECT_EQ(i, lines.size()) << name << ": the run is longer than the golden log";
}

TEST(Golden, disks_of_many_sizes_and_masses) { expect_golden("disks", mixed_box(2, 12, 10.0, 1, 0.2, 50.0), 200); }
TEST(Golden, spheres) { expect_golden("spheres", mixed_box(3, 8, 6.0, 2), 120); }
TEST(Golden, rods) { expect_golden("rods", rods(7, 3), 120); }
TEST(Golden, rack) { expect_golden("rack", rack_and_cue(0.125), 150); }

TEST(Golden, granular) {
  Scene scene = mixed_box(2, 9, 8.0, 4);
  scene.collision.restitution = 0.9;
  expect_golden("granular", scene, 100);
}

TEST(Golden, circle_in_a_box) {
  Scene scene = box({-2.0, -2.0}, {2.0, 2.0});
  scene.walls = {circle({0.0, 0.0}, 0.75, WallSide::outside), circle({0.0, 0.0}, 2.5, WallSide::inside)};
  scene.balls = {ball({1.25, 0.0}, {0.3, 1.0}, 0.2), ball({-1.25, 0.5}, {-0.7, 0.2}, 0.3, 2.5)};
  expect_golden("circles", scene, 100);
}

}  // namespace
}  // namespace carom
