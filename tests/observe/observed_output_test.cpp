// What was measured, as the summary and the table of speeds show it.

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "carom/write/speed_histogram_csv.hpp"
#include "carom/write/summary_json.hpp"
#include "carom/write/summary_table.hpp"
#include "observe/measure.hpp"
#include "sim/scenes.hpp"

namespace carom {
namespace {

using ::testing::HasSubstr;

TEST(ObservedOutput, names_with_dots_are_levels_of_the_summary) {
  RunReport report;
  report.observed = {{"pressure.Z", 1.5, 0.25}, {"collision_rate", 2.0, NAN}, {"pressure.face.x-", 3.0, 0.5}};
  const auto json = nlohmann::json::parse(summary_json(report))["observed"];
  EXPECT_EQ(json["pressure"]["Z"]["value"], 1.5);
  EXPECT_EQ(json["pressure"]["Z"]["error"], 0.25);
  EXPECT_EQ(json["pressure"]["face"]["x-"]["value"], 3.0);
  EXPECT_TRUE(json["collision_rate"]["error"].is_null());
  const std::string table = summary_table(report);
  EXPECT_THAT(table, HasSubstr("pressure.Z        1.5 +- 0.25\n"));
  EXPECT_THAT(table, HasSubstr("collision_rate    2\n"));
}

TEST(ObservedOutput, speeds_are_a_table) {
  Scene scene = testing::open_space(2);
  scene.balls = {testing::ball({0, 0}, {3, 4}), testing::ball({0, 5}, {0, 1})};
  scene.run.until = 1.0;
  scene.observe.speed_histogram = true;
  const auto path = std::filesystem::path(::testing::TempDir()) / "carom_speed_histogram_test.csv";
  {
    SpeedHistogramCsv file(path.string(), Simulation(scene), "speeds");
    file.write(*testing::measure(scene).speeds);
    file.finish(Stop::until);
  }
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  std::filesystem::remove(path);
  double total = 0;
  std::string last;
  bool header = false;
  for (std::string line; std::getline(text, line); last = line) {
    if (line == "from,to,share,density,maxwell") {
      header = true;
    } else if (line[0] != '#') {
      double from = 0, to = 0, share = 0, density = 0, maxwell = 0;
      char comma = 0;
      std::stringstream(line) >> from >> comma >> to >> comma >> share >> comma >> density >> comma >> maxwell;
      EXPECT_DOUBLE_EQ(density * (to - from), share);
      EXPECT_GE(maxwell, 0);
      total += share;
    }
  }
  EXPECT_TRUE(header);
  EXPECT_EQ(total, 1);
  EXPECT_EQ(last, "# end: until");
}

}  // namespace
}  // namespace carom
