// carom sweep: rows, means, threads, resuming.

#include "app/program.hpp"

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "carom/write/number_text.hpp"

namespace carom {
namespace {

using Json = nlohmann::ordered_json;
using test::carom;
using test::Folder;
using testing::HasSubstr;

/// A point in a box with a disk of radius 1/4 in its middle.
const std::string sinai = R"(title = "Sinai"
[space]
kind = "box"
lower = [0, 0]
upper = [1, 1]
[[ball]]
position = [0.1, 0.1]
velocity = [0.6, 0.8]
radius = 0
[[ball]]
position = [0.5, 0.5]
radius = 0.25
fixed = true
[run]
events = 30
[observe]
mean_free_path = true
)";

const std::vector<std::string> random_starts{"sweep", "a.toml", "--vary", "ball.0=random", "--vary", "ball.1.radius=[0.1, 0.3]"};

test::Outcome sweep(const Folder& folder, std::vector<std::string> more, const std::vector<std::string>& base = random_starts) {
  more.insert(more.begin(), base.begin(), base.end());
  return carom(folder, more);
}

/// As carom writes numbers: the shortest text.
std::string toml(const Json& value) {
  if (!value.is_array()) return number_text(value.get<double>());
  std::string s;
  for (const Json& x : value) s += (s.empty() ? "[" : ", ") + toml(x);
  return s + "]";
}

TEST(Sweep, rows_do_not_depend_on_the_number_of_threads) {
  const Folder folder;
  folder.write("a.toml", sinai);
  for (const char* threads : {"1", "2", "7"}) {
    const test::Outcome o = sweep(folder, {"--count", "150", "--threads", threads, "--out", std::string("t") + threads});
    ASSERT_EQ(o.status, 0) << o.err;
  }
  const std::string rows = folder.read("t1/runs.jsonl"), table = folder.read("t1/runs.csv");
  EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 300);
  EXPECT_EQ(folder.read("t2/runs.jsonl"), rows);
  EXPECT_EQ(folder.read("t7/runs.jsonl"), rows);
  EXPECT_EQ(folder.read("t7/runs.csv"), table);
  EXPECT_FALSE(std::filesystem::exists(folder.file("t1/runs.jsonl.part")));
}

// The values of a row, given to carom run, make the same run: same time to the last bit, same path.
TEST(Sweep, a_row_is_a_run_that_can_be_made_again) {
  const Folder folder;
  folder.write("a.toml", sinai);
  for (const char* precision : {"double", "30"}) {
    const test::Outcome rows = sweep(folder, {"--count", "3", "--rows", "--json", "--final", "--precision", precision});
    ASSERT_EQ(rows.status, 0) << rows.err;
    const Json row = Json::parse(test::split(rows.out, '\n').at(5));
    EXPECT_EQ(row["run"], 5);
    std::vector<std::string> words{"run", "a.toml", "--json", "--final", "--precision", precision};
    for (const auto& [key, value] : row["set"].items()) {
      words.push_back("--set");
      words.push_back(key + "=" + toml(value));
    }
    const Json run = Json::parse(carom(folder, words).out);
    EXPECT_EQ(run["time"], row["time"]);
    EXPECT_EQ(run["final"], row["final"]);
    EXPECT_EQ(run["observed"], row["observed"]);
    EXPECT_EQ(run["energy"]["relative_error"], row["energy"]["relative_error"]);
  }
}

// Head-on, equal masses: (1 - e^2)/4 of 2 m v^2/2 each is lost, so of the energy 1 with e: 1 - e^2.
TEST(Sweep, takes_steps_of_any_key) {
  const Folder folder;
  folder.write("a.toml", test::head_on(2));
  const test::Outcome o = carom(folder, {"sweep", "a.toml", "--vary", "collision.restitution=0.2:1:5", "--until", "2", "--rows"});
  ASSERT_EQ(o.status, 0) << o.err;
  const test::Csv csv(o.out);
  ASSERT_EQ(csv.rows.size(), 5U);
  for (std::size_t k = 0; k < 5; ++k) {
    const double e = 0.2 * static_cast<double>(k + 1);
    EXPECT_NEAR(std::stod(csv.rows[k].at("set.collision.restitution")), e, 1e-15);
    EXPECT_NEAR(std::stod(csv.rows[k].at("energy.dissipated")), 1 - e * e, 1e-15);
    EXPECT_EQ(csv.rows[k].at("outcome"), "done");
  }
}

// The mean of 0, 1, ..., 9 is 4.5; their standard deviation is sqrt(55/6), over sqrt(10) the standard error.
TEST(Sweep, means_have_standard_errors_over_runs) {
  const Folder folder;
  folder.write("a.toml", test::head_on(1));
  const test::Outcome o = carom(folder, {"sweep", "a.toml", "--vary", "run.seed=[1, 2]", "--zip", "--vary", "ball.0.mass=[1, 1]",
                                         "--count", "5", "--vary", "run.until=0.25:0.75", "--json"});
  ASSERT_EQ(o.status, 0) << o.err;
  const Json j = Json::parse(o.out);
  EXPECT_EQ(j["runs"], 10);
  EXPECT_EQ(j["done"], 10);
  ASSERT_EQ(j["groups"].size(), 2U);
  EXPECT_EQ(j["groups"][1]["set"]["run.seed"], 2);
  EXPECT_EQ(j["groups"][1]["runs"], 5);

  const test::Outcome rows = carom(folder, {"sweep", "a.toml", "--vary", "run.until=0.25:0.75", "--count", "10", "--rows"});
  double sum = 0, square = 0;
  for (const auto& row : test::Csv(rows.out).rows) {
    const double t = std::stod(row.at("time"));
    sum += t;
    square += t * t;
  }
  const double mean = sum / 10, error = std::sqrt((square / 10 - mean * mean) / 9);
  const Json one = Json::parse(carom(folder, {"sweep", "a.toml", "--vary", "run.until=0.25:0.75", "--count", "10", "--json"}).out);
  EXPECT_NEAR(one["groups"][0]["values"]["time"]["value"].get<double>(), mean, 1e-14);
  EXPECT_NEAR(one["groups"][0]["values"]["time"]["error"].get<double>(), error, 1e-14);
}

// Two infinite masses that meet, and a start with overlap: rows with their reason, and the sweep goes on.
TEST(Sweep, runs_that_cannot_go_on_are_rows) {
  const Folder folder;
  folder.write("a.toml", test::head_on(2, "[[ball]]\nposition = [5, 8]\n"));
  const test::Outcome o = carom(folder, {"sweep", "a.toml", "--vary", "ball.0.mass=[1, \"inf\"]", "--vary",
                                         "ball.1.position=[[6.5, 5], [4, 5]]", "--set", "ball.1.mass=inf", "--until", "3", "--rows", "--json"});
  EXPECT_EQ(o.status, 0) << o.err;
  std::vector<std::string> outcomes, reasons;
  for (const std::string& line : test::split(o.out, '\n')) {
    if (line.empty()) continue;
    const Json row = Json::parse(line);
    outcomes.push_back(row["outcome"]);
    reasons.push_back(row.value("reason", ""));
  }
  ASSERT_THAT(outcomes, testing::ElementsAre("done", "refused", "stopped", "refused"));
  EXPECT_THAT(reasons[1], HasSubstr("overlap"));
  EXPECT_THAT(reasons[2], HasSubstr("infinite"));
}

TEST(Sweep, says_at_once_what_is_wrong) {
  const Folder folder;
  folder.write("a.toml", sinai);
  const test::Outcome wrong = carom(folder, {"sweep", "a.toml", "--vary", "ball.1.raduis=0.1:0.2:3", "--out", "x"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_THAT(wrong.err, testing::AllOf(HasSubstr("--vary ball.1.raduis=0.1"), HasSubstr("Did you mean \"radius\"")));
  EXPECT_FALSE(std::filesystem::exists(folder.file("x")));
  EXPECT_EQ(carom(folder, {"sweep", "a.toml"}).status, 2) << "nothing to vary";
  EXPECT_EQ(carom(folder, {"sweep", "a.toml", "--vary", "ball.0=random", "--resume"}).status, 2) << "no folder";
}

/// A sweep that is cut off: `lines` whole rows and half of the next.
void cut(const Folder& folder, const std::string& from, const std::string& to, std::size_t lines) {
  std::filesystem::create_directories(folder.file(to));
  std::filesystem::copy_file(folder.file(from + "/sweep.json"), folder.file(to + "/sweep.json"));
  const std::string rows = folder.read(from + "/runs.jsonl");
  std::size_t at = 0;
  for (std::size_t k = 0; k < lines; ++k) at = rows.find('\n', at) + 1;
  folder.write(to + "/runs.jsonl.part", rows.substr(0, at + 40));
}

TEST(Sweep, resumes_a_crashed_one_bit_for_bit) {
  const Folder folder;
  folder.write("a.toml", sinai);
  ASSERT_EQ(sweep(folder, {"--count", "20", "--out", "whole"}).status, 0);
  cut(folder, "whole", "cut", 13);
  const test::Outcome again = sweep(folder, {"--count", "20", "--out", "cut"});
  EXPECT_EQ(again.status, 2) << "its rows would be lost";
  EXPECT_THAT(again.err, HasSubstr("--resume"));
  ASSERT_EQ(sweep(folder, {"--count", "20", "--out", "cut", "--resume"}).status, 0);
  EXPECT_EQ(folder.read("cut/runs.jsonl"), folder.read("whole/runs.jsonl"));
  EXPECT_EQ(folder.read("cut/runs.csv"), folder.read("whole/runs.csv"));

  const test::Outcome more = sweep(folder, {"--count", "25", "--out", "cut", "--resume", "--json"});
  EXPECT_EQ(more.status, 0) << "more runs are added at the end";
  ASSERT_EQ(sweep(folder, {"--count", "25", "--out", "long"}).status, 0);
  EXPECT_EQ(folder.read("cut/runs.jsonl"), folder.read("long/runs.jsonl"));
  EXPECT_EQ(Json::parse(more.out)["runs"], 50) << "means are over those that were there, too";

  const test::Outcome other = sweep(folder, {"--count", "25", "--seed", "3", "--out", "cut", "--resume"});
  EXPECT_EQ(other.status, 2);
  EXPECT_THAT(other.err, HasSubstr("seed differs"));
  EXPECT_EQ(folder.read("cut/runs.jsonl"), folder.read("long/runs.jsonl")) << "nothing was touched";
}

TEST(Sweep, is_whole_up_to_an_interrupt_and_goes_on_from_there) {
  const Folder folder;
  folder.write("a.toml", sinai);
  const std::vector<std::string> base{"sweep", "a.toml", "--vary", "ball.0=random", "--events", "100000", "--out", "i"};
  const auto words = [&](std::vector<std::string> more) {
    more.insert(more.begin(), base.begin(), base.end());
    return more;
  };
  test::Program program(folder, words({"--count", "1000000"}));
  const auto grown = [&] {
    std::error_code error;
    return std::filesystem::file_size(folder.file("i/runs.jsonl.part"), error) > 0 && !error;
  };
  for (int k = 0; k < 12000 && !grown(); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  program.send(SIGINT);
  EXPECT_EQ(program.wait().status, 130);
  const std::string part = folder.read("i/runs.jsonl.part");
  ASSERT_TRUE(part.ends_with('\n'));
  const auto rows = std::count(part.begin(), part.end(), '\n');
  ASSERT_GE(rows, 1);
  const std::string count = std::to_string(rows + 2);
  ASSERT_EQ(carom(folder, words({"--count", count, "--resume"})).status, 0);
  EXPECT_TRUE(folder.read("i/runs.jsonl").starts_with(part));
}

// Four processes on one machine, one of which hands out the runs.
TEST(Sweep, rows_do_not_depend_on_the_number_of_processes) {
#ifdef CAROM_MPIRUN
  const Folder folder;
  folder.write("a.toml", sinai);
  ASSERT_EQ(sweep(folder, {"--count", "150", "--out", "threads"}).status, 0);
  const std::string mpirun = "cd '" + folder.path().string() +
                             "' && OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1 "
                             "timeout 120 '" CAROM_MPIRUN "' -n 4 '" CAROM_PROGRAM "' ";
  const std::string command =
      mpirun + "sweep a.toml --vary ball.0=random --vary 'ball.1.radius=[0.1, 0.3]' --count 150 --json --out ranks > out.json";
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(folder.read("ranks/runs.jsonl"), folder.read("threads/runs.jsonl"));
  EXPECT_EQ(folder.read("ranks/runs.csv"), folder.read("threads/runs.csv"));
  EXPECT_EQ(Json::parse(folder.read("out.json"))["runs"], 300) << "one process speaks";
  EXPECT_NE(std::system((mpirun + "sweep none.toml --vary ball.0=random > none.txt 2>&1").c_str()), 0);
  EXPECT_EQ(test::split(folder.read("none.txt"), '\n').at(0).find("carom: cannot read the scene file"), 0U) << folder.read("none.txt");
#else
  GTEST_SKIP() << "carom was built without MPI";
#endif
}

}  // namespace
}  // namespace carom
