#include "carom/write/trajectory_csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "write/scenes.hpp"
#include "write/text_file.hpp"

namespace carom {
namespace {

TEST(TrajectoryCsv, writes_every_ball_at_every_frame) {
  const test::Folder folder;
  const Scene scene = test::head_on(2);
  Simulation simulation(scene);
  TrajectoryCsv table(folder.file("t.csv"), head_of(scene, simulation));
  table.write(frame_of(simulation));
  const Stop stop = simulation.advance(Number(2.0));
  table.write(frame_of(simulation));
  table.finish({std::string(word(stop)), std::nullopt});

  test::Csv csv(folder.read("t.csv"));
  EXPECT_TRUE(csv.whole);
  EXPECT_THAT(csv.header, testing::ElementsAre("time", "ball", "x", "y", "ix", "iy", "vx", "vy", "radius", "mass"));
  ASSERT_EQ(csv.rows.size(), 4U);
  EXPECT_EQ(csv.rows[0]["time"], "0");
  EXPECT_EQ(csv.rows[0]["x"], "3.5");
  EXPECT_EQ(csv.rows[0]["vx"], "1");
  EXPECT_EQ(csv.rows[3]["time"], "2");  // one after the impact at t = 1, x = 5.5
  EXPECT_EQ(csv.rows[3]["ball"], "1");
  EXPECT_EQ(csv.rows[3]["x"], "6.5");
  EXPECT_EQ(csv.rows[3]["y"], "5");
  EXPECT_EQ(csv.rows[3]["vx"], "1");
  EXPECT_EQ(csv.rows[3]["radius"], "0.5");
  EXPECT_EQ(csv.rows[3]["mass"], "1");
  EXPECT_THAT(csv.comments, testing::IsSupersetOf({"# space: box", "# lower: 0 0", "# upper: 10 10"}));
  EXPECT_EQ(csv.comments.back(), "# end: until, 2 frames");
}

}  // namespace
}  // namespace carom
