// Ctrl-C and termination: a run that would not end by itself ends at an event, with everything written.

#include "app/program.hpp"

#include <chrono>
#include <filesystem>
#include <thread>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "carom/write/frame_reader.hpp"
#include "carom/write/trajectory.hpp"

namespace carom {
namespace {

using test::Folder;

/// Starts an endless run, waits until its log has grown, sends the signal.
test::Outcome interrupted(const Folder& folder, int signal, const std::string& trajectory = "t.csv") {
  folder.write("a.toml", test::head_on(2,
                                       "events = 1_000_000_000_000\nsample_every = 1000\n[output]\nevents = \"e.csv\"\n"
                                       "trajectory = \"" + trajectory + "\"\n"));
  test::Program program(folder, {"run", "a.toml", "--json", "--final", "--until", "1e12"});
  const auto grown = [&] {
    std::error_code error;
    const auto size = std::filesystem::file_size(folder.file("e.csv.part"), error);
    return !error && size > 0;
  };
  for (int k = 0; k < 12000 && !grown(); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_TRUE(grown()) << "no log within a minute";
  program.send(signal);
  return program.wait();
}

class InterruptedRun : public testing::TestWithParam<int> {};

TEST_P(InterruptedRun, is_complete_to_its_last_event) {
  const Folder folder;
  const test::Outcome o = interrupted(folder, GetParam());
  EXPECT_EQ(o.status, 128 + GetParam());
  EXPECT_EQ(o.err, "");
  const auto j = nlohmann::json::parse(o.out);
  EXPECT_EQ(j["stopped_by"], "interrupted");
  EXPECT_EQ(j["final"].size(), 2U);

  const test::Csv log(folder.read("e.csv"));
  ASSERT_FALSE(log.rows.empty());
  EXPECT_TRUE(log.whole);
  const std::size_t collisions = j["events"]["ball_ball"].get<std::size_t>() + j["events"]["ball_wall"].get<std::size_t>();
  EXPECT_EQ(log.rows.size(), collisions);
  EXPECT_EQ(log.comments.back(), "# end: interrupted, " + std::to_string(collisions) + " events");
  EXPECT_LE(std::stod(log.rows.back().at("time")), j["time"].get<double>());

  const test::Csv frames(folder.read("t.csv"));
  ASSERT_FALSE(frames.rows.empty());
  EXPECT_TRUE(frames.whole);
  EXPECT_EQ(std::stod(frames.rows.back().at("time")), j["time"].get<double>());
}

TEST(InterruptedH5md, leaves_an_h5md_file_that_is_read) {
  if (!is_built(TrajectoryFormat::h5md)) GTEST_SKIP() << "carom was built without HDF5";
  const Folder folder;
  const test::Outcome o = interrupted(folder, SIGINT, "t.h5");
  EXPECT_EQ(o.status, 130);
  const Survey s = survey(folder.file("t.h5"));
  EXPECT_EQ(s.stopped_by, "interrupted");
  EXPECT_GE(s.frames, 2);
}

// Wherever the signal falls, what it leaves behind goes on under another search and queue to where the run that was left
// alone comes to: the same time, and the same digits of every ball.
TEST(Interrupted, goes_on_from_its_checkpoint_bit_for_bit) {
  const Folder folder;
  folder.write("gas.toml",
               "dimension = 3\n[[gas]]\ncount = 500\npacking_fraction = 0.4\nradius = 0.5\n[run]\nevents = 1_000_000_000_000\n"
               "[output]\nevents = \"e.csv\"\n");
  test::Program program(folder, {"run", "gas.toml", "--json", "--checkpoint", "at.carom"});
  std::error_code error;
  for (int k = 0; k < 12000 && !(std::filesystem::exists(folder.file("e.csv.part"), error) &&
                                 std::filesystem::file_size(folder.file("e.csv.part"), error) > 0);
       ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  program.send(SIGINT);
  const test::Outcome cut = program.wait();
  ASSERT_EQ(cut.status, 130) << cut.err;
  EXPECT_FALSE(std::filesystem::exists(folder.file("at.carom.part")));
  const std::string events = std::to_string(nlohmann::json::parse(cut.out)["events"]["ball_ball"].get<std::int64_t>() + 2000);

  const auto end_of = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"run", "gas.toml", "--set", "output.events=\"\"", "--json", "--final", "--events", events});
    const test::Outcome o = test::carom(folder, words);
    EXPECT_EQ(o.status, 0) << o.err;
    const auto j = nlohmann::json::parse(o.out);
    return std::pair{j["time"], j["final"]};
  };
  const auto alone = end_of({});
  EXPECT_EQ(end_of({"--resume", "at.carom"}), alone);
  EXPECT_EQ(end_of({"--resume", "at.carom", "--set", "engine.search=cells", "--set", "engine.queue=heap"}), alone);
}

INSTANTIATE_TEST_SUITE_P(Signals, InterruptedRun, testing::Values(SIGINT, SIGTERM),
                         [](const auto& test) { return test.param == SIGINT ? "SIGINT" : "SIGTERM"; });

}  // namespace
}  // namespace carom
