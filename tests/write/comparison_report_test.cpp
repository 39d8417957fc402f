#include "carom/write/comparison_report.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "carom/write/comparison_csv.hpp"
#include "write/text_file.hpp"

namespace carom {
namespace {

using testing::HasSubstr;

ComparisonRow row(const std::string& method, const std::string& engine, double dt) {
  ComparisonRow r{method, engine, dt, {}};
  r.result.time = 2.0;
  r.result.steps = 100;
  r.result.seconds = 0.5;
  r.result.collisions = 12345;
  r.result.tally = {3, 2, 1, 4};
  r.result.escaped = 5;
  r.result.energy_error = std::numeric_limits<double>::quiet_NaN();
  r.result.here.collision_rate = 3.0;
  r.result.exact.collision_rate = 2.0;
  return r;
}

ComparisonReport report() {
  ComparisonReport r;
  r.exact.summary.title = "A title";
  r.exact.summary.events.ball_ball = 7;
  r.rows = {row("discrete:iterations=8", "", 0.01), row("", "box2d", 1e-5)};
  r.rows[1].result.diverged_at_collision = 17;
  r.rows[1].result.diverged_at = 0.25;
  return r;
}

// The keys that users rely on come first, in a fixed order.
TEST(ComparisonJson, has_the_keys_of_a_row) {
  const auto j = nlohmann::ordered_json::parse(comparison_json(report()));
  EXPECT_EQ(j["exact"]["events"]["ball_ball"], 7);
  EXPECT_EQ(j["interrupted"], false);
  ASSERT_EQ(j["rows"].size(), 2u);
  std::vector<std::string> keys;
  for (const auto& [key, value] : j["rows"][0].items()) keys.push_back(key);
  keys.resize(14);
  EXPECT_THAT(keys, testing::ElementsAre("method", "engine", "dt", "collisions", "missed", "spurious", "escaped", "swapped",
                                         "deepest_overlap", "energy_error", "momentum_error", "position_error",
                                         "diverged_at_collision", "seconds"));
  const auto &a = j["rows"][0], &b = j["rows"][1];
  EXPECT_EQ(a["method"], "discrete:iterations=8");
  EXPECT_TRUE(a["engine"].is_null());
  EXPECT_EQ(a["missed"], 3);
  EXPECT_EQ(a["missed_pairs"], 2);
  EXPECT_EQ(a["spurious"], 1);
  EXPECT_EQ(a["swapped"], 4);
  EXPECT_EQ(a["escaped"], 5);
  EXPECT_TRUE(a["energy_error"].is_null()) << "not defined";
  EXPECT_TRUE(a["diverged_at_collision"].is_null());
  EXPECT_EQ(a["seconds_per_time"], 0.25);
  EXPECT_TRUE(b["method"].is_null());
  EXPECT_EQ(b["engine"], "box2d");
  EXPECT_EQ(b["diverged_at_collision"], 17);
  EXPECT_EQ(b["averages"]["stepper"]["collision_rate"], 3.0);
  EXPECT_EQ(b["averages"]["exact"]["collision_rate"], 2.0);
}

TEST(ComparisonTable, stands_in_columns) {
  const std::string text = comparison_table(report());
  EXPECT_THAT(text, HasSubstr("7 collisions to time 0"));
  EXPECT_THAT(text, HasSubstr("collision 17"));
  EXPECT_THAT(text, HasSubstr("1.5")) << "the ratio of the rates";
  std::vector<std::size_t> widths;
  for (const std::string& line : test::split(text, '\n'))
    if (line.starts_with("  discrete:") || line.starts_with("  box2d") || line.find("missed") != std::string::npos)
      widths.push_back(line.size());
  ASSERT_EQ(widths.size(), 5u);
  EXPECT_EQ(widths[0], widths[1]);
  EXPECT_EQ(widths[0], widths[2]);
  EXPECT_EQ(widths[3], widths[4]);
}

TEST(ComparisonCsv, has_a_cell_for_every_column) {
  const test::Folder folder;
  {
    ComparisonCsv file(folder.file("rows.csv"));
    for (const ComparisonRow& r : report().rows) file.write(r);
    EXPECT_EQ(test::Csv(folder.read("rows.csv.part")).rows.size(), 2u) << "readable while it is written";
    file.finish();
    PositionErrorCsv errors(folder.file("errors.csv"));
    errors.write(report().rows[1], 0.5, 0.125);
    errors.finish();
  }
  const test::Csv rows(folder.read("rows.csv"));
  EXPECT_TRUE(rows.whole);
  EXPECT_EQ(rows.rows[0].at("energy_error"), "");
  EXPECT_EQ(rows.rows[1].at("diverged_at_time"), "0.25");
  EXPECT_EQ(rows.rows[1].at("exact_collision_rate"), "2");
  EXPECT_EQ(test::split(folder.read("errors.csv"), '\n')[1], ",box2d,1e-05,0.5,0.125");
}

}  // namespace
}  // namespace carom
