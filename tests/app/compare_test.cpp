// carom compare: fixed steps beside the exact run, what is refused, what is left when it is stopped.

#include "app/program.hpp"

#include <chrono>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "carom/game_engine/game_engine.hpp"

namespace carom {
namespace {

using nlohmann::json;
using test::carom;
using test::Folder;
using testing::AllOf;
using testing::HasSubstr;

/// Radius 0.01, a gap of 1 that closes at 200: t = 0.005. A step of 0.01 ends when each has moved by 1.
const char* const fast =
    "title = \"Fast\"\n[[ball]]\nposition = [-0.51, 0]\nvelocity = [100, 0]\nradius = 0.01\n[[ball]]\nposition = [0.51, "
    "0]\n"
    "velocity = [-100, 0]\nradius = 0.01\n[run]\n";

json rows_of(const Folder& folder, std::vector<std::string> words) {
  words.insert(words.begin(), {"compare", "a.toml", "--json"});
  const test::Outcome o = carom(folder, words);
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_EQ(o.err, "");
  return json::parse(o.out);
}

TEST(CompareCommand, sees_tunnelling) {
  const Folder folder;
  folder.write("a.toml", std::string(fast) + "until = 0.1\n");
  const json j = rows_of(folder, {"--dt", "1e-2", "--method", "discrete,swept"});
  EXPECT_EQ(j["exact"]["events"]["ball_ball"], 1);
  EXPECT_EQ(j["exact"]["time"], 0.1);
  EXPECT_EQ(j["interrupted"], false);
  ASSERT_EQ(j["rows"].size(), 2u);
  const json &discrete = j["rows"][0], &swept = j["rows"][1];
  EXPECT_EQ(discrete["method"], "discrete");
  EXPECT_TRUE(discrete["engine"].is_null());
  EXPECT_EQ(discrete["dt"], 0.01);
  EXPECT_EQ(discrete["steps"], 10);
  EXPECT_EQ(discrete["collisions"], 0);
  EXPECT_EQ(discrete["missed"], 1);
  EXPECT_EQ(discrete["diverged_at_collision"], 1);
  EXPECT_NEAR(discrete["position_error"].get<double>(), 19.0, 1e-12) << "2 x 100 x (0.1 - 0.005)";
  EXPECT_EQ(swept["collisions"], 1);
  EXPECT_EQ(swept["missed"], 0);
  EXPECT_LE(swept["position_error"], 1e-12);
  EXPECT_TRUE(swept["diverged_at_collision"].is_null());
  for (const char* key : {"spurious", "escaped", "swapped", "deepest_overlap", "energy_error", "momentum_error"}) {
    EXPECT_EQ(discrete[key], 0) << key;
    EXPECT_EQ(swept[key], 0) << key;
  }
  EXPECT_GT(discrete["seconds"], 0.0);
}

// All of carom's own methods, if none is named; all steps of a method one after the other.
TEST(CompareCommand, takes_every_method_at_every_step) {
  const Folder folder;
  folder.write("a.toml", std::string(fast) + "until = 0.1\n");
  const json j = rows_of(folder, {"--dt", "1e-2, 1/500"});
  ASSERT_EQ(j["rows"].size(), 8u);
  const char* const names[] = {"discrete", "swept", "speculative", "penalty"};
  for (std::size_t k = 0; k < 8; ++k) {
    EXPECT_EQ(j["rows"][k]["method"], names[k / 2]);
    EXPECT_EQ(j["rows"][k]["dt"], k % 2 == 0 ? 0.01 : 0.002);
  }
  const json one = rows_of(folder, {"--dt", "1e-3", "--method", "discrete:iterations=4"});
  EXPECT_EQ(one["rows"][0]["method"], "discrete:iterations=4");
}

// Without an end the last collision is the end; the last step goes beyond it.
TEST(CompareCommand, ends_at_the_last_collision) {
  const Folder folder;
  folder.write("a.toml", std::string(fast) + "events = 100\n");
  const json j = rows_of(folder, {"--dt", "2e-3", "--method", "swept"});
  EXPECT_DOUBLE_EQ(j["exact"]["time"].get<double>(), 0.005);
  EXPECT_EQ(j["rows"][0]["steps"], 3);
  EXPECT_EQ(j["rows"][0]["collisions"], 1);
  const test::Outcome o = carom(
      folder, {"compare", "a.toml", "--dt", "1e-3", "--set", "ball.0.velocity=[-100,0]", "--set", "ball.1.velocity=[1,0]"});
  EXPECT_EQ(o.status, 2);
  EXPECT_THAT(o.err, HasSubstr("--until"));
}

TEST(CompareCommand, prints_a_table_for_people) {
  const Folder folder;
  folder.write("a.toml", std::string(fast) + "until = 0.1\n");
  const test::Outcome o = carom(folder, {"compare", "a.toml", "--dt", "1e-2", "--method", "discrete"});
  EXPECT_EQ(o.status, 0);
  EXPECT_THAT(o.out, AllOf(HasSubstr("Fast"), HasSubstr("missed"), HasSubstr("collision 1"), HasSubstr("  took ")));
}

TEST(CompareCommand, writes_its_files) {
  const Folder folder;
  folder.write("a.toml", std::string(fast) + "until = 0.1\n[output]\nevents = \"not_this_one.csv\"\n");
  rows_of(folder, {"--dt", "1e-2,1e-3", "--method", "discrete,swept", "--out", "o"});
  EXPECT_THAT(folder.files(), testing::Not(testing::Contains("not_this_one.csv")));
  const test::Csv rows(folder.read("o/rows.csv")), errors(folder.read("o/position_error.csv")),
      events(folder.read("o/events.csv"));
  EXPECT_TRUE(rows.whole && errors.whole && events.whole);
  ASSERT_EQ(rows.rows.size(), 4u);
  EXPECT_EQ(rows.rows[0].at("method"), "discrete");
  EXPECT_EQ(rows.rows[0].at("engine"), "");
  EXPECT_EQ(rows.rows[0].at("missed"), "1");
  EXPECT_EQ(rows.rows[2].at("diverged_at_collision"), "");
  EXPECT_EQ(events.rows.size(), 1u);
  ASSERT_EQ(errors.rows.size(), 2u * (11 + 101)) << "the start and the end of every step";
  EXPECT_EQ(errors.rows[0].at("error"), "0");
  EXPECT_EQ(errors.rows[10].at("time"), "0.1");
  EXPECT_NEAR(std::stod(errors.rows[10].at("error")), 19.0, 1e-12);
}

TEST(CompareCommand, lists_all_that_is_wrong) {
  const Folder folder;
  folder.write("a.toml", std::string(fast) + "until = 0.1\n");
  const test::Outcome o =
      carom(folder, {"compare", "a.toml", "--dt", "0,abc,-1,inf,1e999,1e-2", "--method", "discrete,swepd,penalty:colour=3",
                     "--engine", "box3d", "--set", "ball.0.radius=-1", "--out", "o"});
  EXPECT_EQ(o.status, 2);
  EXPECT_EQ(o.out, "");
  EXPECT_THAT(o.err,
              AllOf(HasSubstr("--dt 0"), HasSubstr("abc"), HasSubstr("--dt -1"), HasSubstr("--dt inf"), HasSubstr("1e999"),
                    HasSubstr("swepd"), HasSubstr("speculative"), HasSubstr("colour"), HasSubstr("contact_time")));
  EXPECT_THAT(o.err, AllOf(HasSubstr("box3d"), HasSubstr("chipmunk"), HasSubstr("radius")));
  EXPECT_EQ(folder.files().size(), 3u) << "the scene, stdout and stderr";
  EXPECT_EQ(carom(folder, {"compare", "a.toml"}).status, 2) << "no steps";
  EXPECT_EQ(carom(folder, {"compare", "a.toml", "--dt", ""}).status, 2);
  EXPECT_EQ(carom(folder, {"compare", "a.toml", "--dt", "1e-30"}).status, 2) << "too many steps";
  EXPECT_EQ(carom(folder, {"compare", "a.toml", "--dt", "1e-2", "--set", "collision.law=\"stick\""}).status, 2);
}

TEST(CompareCommand, does_not_write_over_its_scene) {
  const Folder folder;
  folder.write("rows.csv", std::string(fast) + "until = 0.1\n");
  const test::Outcome o = carom(folder, {"compare", "rows.csv", "--dt", "1e-2", "--out", "."});
  EXPECT_EQ(o.status, 2);
  EXPECT_THAT(o.err, HasSubstr("overwrite"));
  EXPECT_THAT(folder.read("rows.csv"), HasSubstr("Fast"));
}

// An engine is either there, or said to be missing by the name of its package.
TEST(CompareCommand, engines_are_there_or_named) {
  const Folder folder;
  folder.write("a.toml", test::head_on(2));
  for (const GameEngine& engine : game_engines()) {
    const test::Outcome o = carom(folder, {"compare", "a.toml", "--dt", "1e-3", "--engine", engine.name, "--json"});
    if (engine.built) {
      ASSERT_EQ(o.status, 0) << o.err;
      const json j = json::parse(o.out);
      ASSERT_EQ(j["rows"].size(), 1u) << "no method, where only an engine is named";
      EXPECT_EQ(j["rows"][0]["engine"], engine.name);
      EXPECT_TRUE(j["rows"][0]["method"].is_null());
    } else {
      EXPECT_EQ(o.status, 2);
      EXPECT_THAT(o.err, HasSubstr(engine.package));
    }
  }
}

// A ball that comes to rest has infinitely many impacts: there is no exact run to compare with.
TEST(CompareCommand, has_no_rows_where_the_exact_run_collapses) {
  const Folder folder;
  folder.write("a.toml",
               "dimension = 1\n[motion]\nacceleration = [-1]\n[collision]\nrestitution = 0.5\n[[ball]]\nposition = [2]\n"
               "[[wall]]\nkind = \"plane\"\npoint = [0]\nnormal = [1]\n[run]\nuntil = 100\n");
  const test::Outcome o = carom(folder, {"compare", "a.toml", "--dt", "1e-2", "--json"});
  EXPECT_EQ(o.status, 3);
  EXPECT_THAT(o.err, AllOf(HasSubstr("infinitely many"), HasSubstr("--until")));
  const json j = json::parse(o.out);
  EXPECT_EQ(j["exact"]["stopped_by"], "collapse");
  EXPECT_TRUE(j["rows"].empty());
}

// The first row is done at once, the second would take 10^11 steps.
TEST(CompareCommand, keeps_the_rows_that_are_finished_when_interrupted) {
  const Folder folder;
  folder.write("a.toml", std::string(fast) + "until = 100\n");
  test::Program program(folder, {"compare", "a.toml", "--dt", "1e-2,1e-9", "--method", "discrete", "--json", "--out", "o"});
  const auto rows = [&] {
    std::error_code none;
    const bool there = std::filesystem::exists(folder.file("o/rows.csv.part"), none);
    return there ? test::Csv(folder.read("o/rows.csv.part")).rows.size() : std::size_t{0};
  };
  for (int k = 0; k < 12000 && rows() == 0; ++k) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(rows(), 1u) << "no row within a minute";
  program.send(SIGINT);
  const test::Outcome o = program.wait();
  EXPECT_EQ(o.status, 130);
  const json j = json::parse(o.out);
  EXPECT_EQ(j["rows"].size(), 1u);
  EXPECT_EQ(j["interrupted"], true);
  EXPECT_THAT(o.err, HasSubstr("interrupted"));
  EXPECT_TRUE(test::Csv(folder.read("o/position_error.csv")).whole);
}

}  // namespace
}  // namespace carom
