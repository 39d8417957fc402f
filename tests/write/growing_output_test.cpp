// Balls that grow, in what is written: every frame has the radius of its moment.

#include <gtest/gtest.h>

#include "carom/write/frame_reader.hpp"
#include "carom/write/summary_json.hpp"
#include "carom/write/trajectory.hpp"
#include "write/scenes.hpp"
#include "write/text_file.hpp"

namespace carom {
namespace {

/// Radii 1/2 + t / 8.
Scene growing_pair() {
  Scene scene = test::head_on(2);
  for (BallSpec& b : scene.balls) b.radius_growth = 0.125;
  return scene;
}

class GrowingFrames : public ::testing::TestWithParam<const char*> {};

TEST_P(GrowingFrames, have_the_radius_of_their_moment) {
  const std::string name = std::string("grown.") + GetParam();
  if (!is_built(*trajectory_format(name))) GTEST_SKIP() << "built without HDF5";
  const test::Folder folder;
  const Scene scene = growing_pair();
  Simulation simulation(scene);
  const auto file = begin_trajectory(folder.file(name), head_of(scene, simulation), {});
  for (const double t : {0.0, 0.5, 2.0}) {
    simulation.advance(Number(t));
    file->write(frame_of(simulation));
  }
  file->finish({});
  const auto reader = read_frames(folder.file(name));
  TrajectoryFrame frame;
  for (const double radius : {0.5, 0.5625, 0.75}) {
    ASSERT_TRUE(reader->next(frame));
    ASSERT_EQ(frame.balls.size(), 2U);
    for (const BallState& b : frame.balls) EXPECT_EQ(b.radius.value, radius);
  }
  if (name.ends_with("xyz")) {
    EXPECT_EQ(folder.read(name).find("He "), std::string::npos) << "they stay of one species";
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, GrowingFrames, ::testing::Values("xyz", "csv", "h5"),
                         [](const ::testing::TestParamInfo<const char*>& one) { return std::string(one.param); });

TEST(GrowingSummary, says_how_full_the_space_is) {
  RunReport report;
  Simulation simulation(growing_pair());
  simulation.advance(Number(2.0));
  report.summary = simulation.summary();
  ASSERT_TRUE(report.summary.growth);
  EXPECT_NEAR(*report.summary.growth->packing_fraction, 2 * 3.14159265358979 * 0.75 * 0.75 / 100, 1e-15);
  EXPECT_NE(summary_json(report).find("\"reduced_pressure\": null"), std::string::npos);
  report.summary = Simulation(test::head_on(2)).summary();
  EXPECT_EQ(summary_json(report).find("packing_fraction"), std::string::npos);
}

}  // namespace
}  // namespace carom
