#include "carom/write/events_csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "write/scenes.hpp"
#include "write/text_file.hpp"

namespace carom {
namespace {

using testing::ElementsAre;

std::string log_of(const Scene& scene) {
  const test::Folder folder;
  Simulation simulation(scene);
  EventsCsv log(folder.file("events.csv"), simulation, scene.title);
  const Stop stop = simulation.run([&log](const Collision& c) { log.write(c); });
  log.finish(stop);
  return folder.read("events.csv");
}

TEST(EventsCsv, has_the_columns_of_the_dimension) {
  EXPECT_THAT(test::Csv(log_of(test::head_on(1))).header,
              ElementsAre("time", "epoch", "offset", "kind", "ball", "partner", "feature", "x", "ix", "vx", "px", "pix",
                          "pvx", "impulse", "tie"));
  EXPECT_THAT(test::Csv(log_of(test::head_on(2))).header,
              ElementsAre("time", "epoch", "offset", "kind", "ball", "partner", "feature", "x", "y", "ix", "iy", "vx", "vy",
                          "px", "py", "pix", "piy", "pvx", "pvy", "impulse", "tie"));
  EXPECT_THAT(test::Csv(log_of(test::head_on(3))).header,
              ElementsAre("time", "epoch", "offset", "kind", "ball", "partner", "feature", "x", "y", "z", "ix", "iy", "iz",
                          "vx", "vy", "vz", "px", "py", "pz", "pix", "piy", "piz", "pvx", "pvy", "pvz", "impulse", "tie"));
}

TEST(EventsCsv, holds_every_collision) {
  for (const int dimension : {1, 2, 3}) {
    const test::Csv log(log_of(test::head_on(dimension)));
    EXPECT_TRUE(log.whole);
    ASSERT_EQ(log.rows.size(), 3U);
    auto pair = log.rows[0];
    EXPECT_EQ(pair["time"], "1");
    EXPECT_EQ(pair["kind"], "ball_ball");
    EXPECT_EQ(pair["ball"], "0");
    EXPECT_EQ(pair["partner"], "1");
    EXPECT_EQ(pair["x"], "4.5");
    EXPECT_EQ(pair["vx"], "-1");
    EXPECT_EQ(pair["px"], "5.5");
    EXPECT_EQ(pair["pvx"], "1");
    EXPECT_EQ(pair["impulse"], "2");  // each momentum turns from 1 to -1
    EXPECT_EQ(pair["tie"], "0");
    auto face = log.rows[1];
    EXPECT_EQ(face["time"], "5");
    EXPECT_EQ(face["kind"], "ball_wall");
    EXPECT_EQ(face["partner"], "x-");
    EXPECT_EQ(face["x"], "0.5");
    EXPECT_EQ(face["vx"], "1");
    for (const char* empty : {"px", "pix", "pvx"}) EXPECT_EQ(face[empty], "") << empty;
    EXPECT_EQ(log.rows[2].at("partner"), "x+");
  }
}

TEST(EventsCsv, epoch_and_offset_are_the_time) {
  Scene scene = test::head_on(2);
  scene.run.start = 0.0;
  scene.balls[1].velocity[0] = -0.7;  // 2 / 1.7 is no dyadic number
  Simulation simulation(scene);
  const double length = simulation.epoch_length();
  for (auto& row : test::Csv(log_of(scene)).rows) {
    const double offset = std::stod(row["offset"]);
    EXPECT_GE(offset, 0.0);
    EXPECT_LT(offset, length);
    // Two roundings apart at most: the sum here, and that of the written time.
    EXPECT_NEAR(std::stod(row["epoch"]) * length + offset, std::stod(row["time"]), 1e-15 * std::stod(row["time"]));
  }
}

TEST(EventsCsv, says_what_it_is_and_how_it_ended) {
  Scene scene = test::head_on(2);
  scene.title = "Two\nlines";
  const test::Csv log(log_of(scene));
  ASSERT_EQ(log.comments.size(), 5U);
  EXPECT_EQ(log.comments[1], "# title: Two lines");
  EXPECT_EQ(log.comments[2], "# dimension: 2");
  EXPECT_THAT(log.comments[3], testing::MatchesRegex("# epoch_length: 0x1p[-+][0-9]+ = [0-9.e-]+"));
  EXPECT_EQ(log.comments[4], "# end: until, 3 events");
}

}  // namespace
}  // namespace carom
