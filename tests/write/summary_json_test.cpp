#include "carom/write/summary_json.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "carom/sim/simulation.hpp"
#include "write/scenes.hpp"

namespace carom {
namespace {

using Json = nlohmann::ordered_json;
using testing::ElementsAre;

std::vector<std::string> keys(const Json& object) {
  std::vector<std::string> list;
  for (const auto& [key, value] : object.items()) list.push_back(key);
  return list;
}

RunReport report_of(const Scene& scene) {
  Simulation simulation(scene);
  simulation.run();
  RunReport report;
  report.summary = simulation.summary();
  report.final = simulation.balls();
  report.seconds = 0.5;
  return report;
}

Json json_of(const RunReport& report) { return Json::parse(summary_json(report)); }

TEST(SummaryJson, has_the_keys_of_the_interface_in_order) {
  const Json j = json_of(report_of(test::head_on(2)));
  EXPECT_THAT(keys(j), ElementsAre("title", "dimension", "balls", "composition", "precision", "seed", "epoch_length",
                                   "time", "stopped_by", "events", "energy", "momentum", "angular_momentum", "exactness",
                                   "observed", "final", "seconds", "collisions_per_second", "peak_memory_mb"));
  EXPECT_THAT(keys(j["events"]), ElementsAre("ball_ball", "ball_wall", "other", "ties"));
  EXPECT_THAT(keys(j["energy"]), ElementsAre("initial", "final", "dissipated", "injected", "relative_error"));
  EXPECT_THAT(keys(j["momentum"]), ElementsAre("initial", "final", "relative_error"));
  EXPECT_THAT(keys(j["angular_momentum"]), ElementsAre("initial", "final", "relative_error"));
  EXPECT_THAT(keys(j["exactness"]),
              ElementsAre("max_gap_error", "max_gap_error_relative", "clamped", "unresolved", "singular", "summed_bounces", "repredicted"));
  EXPECT_THAT(keys(j["final"][0]), ElementsAre("index", "name", "position", "image", "unwrapped_position", "velocity"));
}

TEST(SummaryJson, tells_the_run) {
  const Json j = json_of(report_of(test::head_on(2)));
  EXPECT_EQ(j["events"]["ball_ball"], 1);
  EXPECT_EQ(j["events"]["ball_wall"], 2);
  EXPECT_EQ(j["collisions_per_second"], 6.0);
  EXPECT_EQ(j["stopped_by"], "until");
  EXPECT_EQ(j["time"], 6.0);
  EXPECT_EQ(j["energy"]["final"], 1.0);
  EXPECT_EQ(j["final"][0]["name"], "left");
  EXPECT_EQ(j["final"][0]["position"], Json({1.5, 5.0}));  // from the face at t = 5, x = 0.5
  EXPECT_EQ(j["observed"], Json::object());
  EXPECT_THAT(j["epoch_length"].get<std::string>(), testing::StartsWith("0x1p"));
}

TEST(SummaryJson, has_final_only_if_it_is_there) {
  RunReport report = report_of(test::head_on(2));
  report.final.reset();
  EXPECT_FALSE(json_of(report).contains("final"));
}

TEST(SummaryJson, shapes_turning_by_the_dimension) {
  const Json line = json_of(report_of(test::head_on(1)))["angular_momentum"];
  EXPECT_TRUE(line["initial"].is_null());
  EXPECT_TRUE(line["relative_error"].is_null());
  EXPECT_TRUE(json_of(report_of(test::head_on(2)))["angular_momentum"]["initial"].is_number());
  EXPECT_EQ(json_of(report_of(test::head_on(3)))["angular_momentum"]["initial"].size(), 3U);
}

TEST(SummaryJson, is_null_where_nothing_is_conserved) {
  EXPECT_TRUE(json_of(report_of(test::head_on(2)))["momentum"]["relative_error"].is_null());
  Scene open = test::head_on(2);
  open.space = {};
  EXPECT_EQ(json_of(report_of(open))["momentum"]["relative_error"], 0.0);
}

TEST(SummaryJson, writes_what_is_not_finite_as_null_and_doubles_as_doubles) {
  RunReport report = report_of(test::head_on(2));
  report.summary.energy.initial = std::numeric_limits<double>::quiet_NaN();
  report.summary.energy.final = -std::numeric_limits<double>::infinity();
  report.summary.energy.dissipated = 0.1 + 0.2;
  report.summary.energy.injected = 3.0;
  EXPECT_THAT(summary_json(report), testing::HasSubstr("\"initial\": null, \"final\": null, \"dissipated\": "
                                                       "0.30000000000000004, \"injected\": 3.0, "));
}

TEST(SummaryJson, names_the_balls_of_a_stop) {
  RunReport report = report_of(test::head_on(2));
  report.summary.stopped_by = Stop::collapse;
  report.summary.stopped = StopDetail{"why", {3, 5}, 1.25};
  const Json j = json_of(report);
  EXPECT_EQ(j["stopped"], Json::parse(R"({"reason": "why", "balls": [3, 5], "time": 1.25})"));
}

TEST(SummaryJson, escapes_text) {
  RunReport report = report_of(test::head_on(2));
  report.summary.title = "a \"quoted\"\nline \xff";
  EXPECT_EQ(json_of(report)["title"], "a \"quoted\"\nline \xEF\xBF\xBD");
}

}  // namespace
}  // namespace carom
