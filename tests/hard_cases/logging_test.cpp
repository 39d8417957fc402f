// Row 23: writing a log must not change the result. With a sink and without, the final state is the same bytes: contacts,
// stamps, books and all.

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

TEST(Logging, leaves_the_same_bytes) {
  Scene granular = mixed_box(2, 16, 9.0, 231, 0.8);
  granular.collision.restitution = 0.9;
  Scene points = open_space(2);
  points.walls = {polygon({{0.0, 0.0}, {2.0, 0.1}, {1.7, 1.9}, {1.0, 0.9}, {0.1, 1.5}})};
  points.balls = {ball({0.5, 0.3}, {0.3, 0.777}, 0.0)};
  Scene gravity = mixed_box(3, 8, 6.0, 232);
  gravity.motion.acceleration = {0.0, 0.0, -1.0};
  for (const Scene& scene : {granular, points, gravity, rack_and_cue(), rods(12, 233)}) {
    Simulation silent(scene), logged(scene);
    std::size_t lines = 0;
    const Stop a = silent.advance(std::nullopt, 700);
    const Stop b = logged.advance(std::nullopt, 700, [&](const Collision&) { ++lines; });
    EXPECT_EQ(a, b);
    EXPECT_EQ(lines, std::size_t(silent.counts().collisions()));
    EXPECT_EQ(silent.state(), logged.state());
    EXPECT_EQ(logged.audit(AuditBy::every_pair).overlaps, 0);
    EXPECT_EQ(logged.summary().exactness.clamped, 0);
  }
}

}  // namespace
}  // namespace carom
