// carom run: the files it writes.

#include "app/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "carom/write/trajectory.hpp"
#include "write/python.hpp"

namespace carom {
namespace {

using test::carom;
using test::Csv;
using test::Folder;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string outputs = "[output]\nevents = \"e.csv\"\ntrajectory = \"t.csv\"\n";

TEST(RunOutput, is_written_in_every_dimension) {
  for (const int dimension : {1, 2, 3}) {
    const Folder folder;
    folder.write("a.toml", test::head_on(dimension, "sample_every = 2\n" + outputs));
    ASSERT_EQ(carom(folder, {"run", "a.toml"}).status, 0);
    const Csv events(folder.read("e.csv")), frames(folder.read("t.csv"));
    EXPECT_TRUE(events.whole && frames.whole);
    EXPECT_EQ(events.rows.size(), 3U);
    EXPECT_EQ(events.header.size(), 9U + 6U * static_cast<std::size_t>(dimension));
    EXPECT_EQ(frames.header.size(), 4U + 3U * static_cast<std::size_t>(dimension));
    std::vector<std::string> times;
    for (const auto& row : frames.rows)
      if (row.at("ball") == "0") times.push_back(row.at("time"));
    EXPECT_THAT(times, ElementsAre("0", "2", "4", "6")) << "the end is a sample, and written once";
  }
}

TEST(RunOutput, frames_do_not_drift_and_include_the_end) {
  const Folder folder;
  folder.write("a.toml", test::head_on(2, "sample_every = 0.1\n" + outputs));
  ASSERT_EQ(carom(folder, {"run", "a.toml", "--until", "4.05"}).status, 0);
  const Csv frames(folder.read("t.csv"));
  ASSERT_EQ(frames.rows.size(), 2U * 42U);
  for (int k = 0; k <= 40; ++k)
    EXPECT_EQ(std::stod(frames.rows[static_cast<std::size_t>(2 * k)].at("time")), k / 10.0) << k;
  EXPECT_EQ(frames.rows.back().at("time"), "4.05");
}

TEST(RunOutput, sampling_changes_no_event) {
  const Folder folder;
  const std::string lively = test::head_on(2, outputs) + "[[ball]]\nposition = [2, 2]\nvelocity = [0.3, 1.7]\n";
  folder.write("a.toml", lively);
  ASSERT_EQ(carom(folder, {"run", "a.toml", "--events", "3000", "--set", "run.until=1e9"}).status, 0);
  const std::string plain = folder.read("e.csv");
  ASSERT_EQ(carom(folder, {"run", "a.toml", "--events", "3000", "--set", "run.until=1e9", "--set", "run.sample_every=0.37"})
                .status,
            0);
  EXPECT_EQ(folder.read("e.csv"), plain);
  EXPECT_GT(Csv(folder.read("t.csv")).rows.size(), 3000U);
}

TEST(RunOutput, goes_into_the_folder_that_is_named) {
  const Folder folder;
  folder.write("a.toml", test::head_on(2, outputs));
  EXPECT_EQ(carom(folder, {"run", "a.toml", "--out", "deep/down"}).status, 0);
  EXPECT_TRUE(std::filesystem::exists(folder.file("deep/down/e.csv")));
  EXPECT_TRUE(std::filesystem::exists(folder.file("deep/down/t.csv")));
  EXPECT_FALSE(std::filesystem::exists(folder.file("e.csv")));
}

TEST(RunOutput, is_not_touched_by_a_wrong_scene) {
  const Folder folder;
  folder.write("a.toml", test::head_on(2, outputs));
  folder.write("e.csv", "precious");
  for (const std::string wrong : {"ball.1.position=[4,5]", "ball.1.radius=-1", "nonsense=1"}) {
    EXPECT_EQ(carom(folder, {"run", "a.toml", "--out", "results", "--set", wrong}).status, 2) << wrong;
    EXPECT_EQ(carom(folder, {"run", "a.toml", "--set", wrong}).status, 2) << wrong;
  }
  EXPECT_FALSE(std::filesystem::exists(folder.file("results")));
  EXPECT_FALSE(std::filesystem::exists(folder.file("t.csv")));
  EXPECT_EQ(folder.read("e.csv"), "precious");
}

TEST(RunOutput, never_overwrites_the_scene) {
  const Folder folder;
  const std::string scene = test::head_on(2, "[output]\nevents = \"a.toml\"\n");
  folder.write("a.toml", scene);
  EXPECT_EQ(carom(folder, {"run", "./a.toml"}).status, 2);
  EXPECT_EQ(folder.read("a.toml"), scene);
}

TEST(RunOutput, that_cannot_be_opened_is_status_3) {
  const Folder folder;
  folder.write("a.toml", test::head_on(2, outputs));
  folder.write("taken", "a file");
  const test::Outcome o = carom(folder, {"run", "a.toml", "--out", "taken", "--json"});
  EXPECT_EQ(o.status, 3);
  EXPECT_EQ(o.out, "");
  EXPECT_THAT(o.err, HasSubstr("taken"));
  const test::Outcome lost = carom(folder, {"run", "a.toml", "--set", "output.events=none/e.csv"});
  EXPECT_EQ(lost.status, 3);
  EXPECT_THAT(lost.err, testing::AllOf(HasSubstr("none/e.csv"), HasSubstr("No such file or directory")));
}

TEST(RunOutput, on_a_full_disk_is_status_3_and_ends_the_run) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP();
  const Folder folder;
  folder.write("a.toml", test::head_on(2, "[output]\nevents = \"/dev/full\"\n"));
  const test::Outcome small = carom(folder, {"run", "a.toml", "--json"});
  EXPECT_EQ(small.status, 3);
  EXPECT_THAT(small.err, testing::AllOf(HasSubstr("/dev/full"), HasSubstr("No space left")));
  EXPECT_EQ(nlohmann::json::parse(small.out)["stopped_by"], "until") << "found when the log was closed";

  const test::Outcome endless = carom(folder, {"run", "a.toml", "--json", "--until", "1e9"});  // ends only by that failure
  EXPECT_EQ(endless.status, 3);
  EXPECT_EQ(nlohmann::json::parse(endless.out)["stopped_by"], "interrupted");
}

// A gas of ten free points: samples at 0, 1, ..., 6.
TEST(RunOutput, has_a_table_for_each_curve_that_is_measured) {
  const Folder folder;
  folder.write("a.toml", R"(dimension = 2
space = { kind = "periodic", lower = [0, 0], upper = [9, 9] }
[[gas]]
count = 10
radius = 0
[run]
until = 6
[observe]
radial_distribution = { every = 1, bins = 5, r_max = 4 }
mean_squared_displacement = { every = 1, lags = 3 }
velocity_autocorrelation = { every = 1, lags = 2 }
)");
  const auto o = carom(folder, {"run", "a.toml", "--json"});
  ASSERT_EQ(o.status, 0) << o.err;
  const auto observed = nlohmann::json::parse(o.out)["observed"];
  EXPECT_NEAR(observed["velocity_autocorrelation"]["initial"]["value"].get<double>(), 2 * 9.0 / 10, 1e-12);
  EXPECT_TRUE(observed["mean_squared_displacement"].contains("diffusion"));
  const Csv g(folder.read("radial_distribution.csv")), msd(folder.read("mean_squared_displacement.csv")),
      vacf(folder.read("velocity_autocorrelation.csv"));
  EXPECT_THAT(g.header, ElementsAre("from", "to", "g", "error"));
  EXPECT_THAT(msd.header, ElementsAre("lag", "msd", "error"));
  EXPECT_THAT(vacf.header, ElementsAre("lag", "vacf", "error"));
  EXPECT_EQ(g.rows.size(), 5U);
  EXPECT_EQ(msd.rows.size(), 4U);
  EXPECT_NEAR(std::stod(msd.rows[3].at("msd")), 9 * 2 * 9.0 / 10, 1e-10);
  EXPECT_EQ(vacf.rows.size(), 3U);
  EXPECT_TRUE(g.whole && msd.whole && vacf.whole);
}

TEST(RunOutput, of_curves_does_not_overwrite_another_file) {
  const Folder folder;
  folder.write("a.toml", test::head_on(2, "[observe]\nmean_squared_displacement = true\n"
                                          "[output]\nevents = \"mean_squared_displacement.csv\"\n"));
  const auto o = carom(folder, {"run", "a.toml"});
  EXPECT_EQ(o.status, 2);
  EXPECT_THAT(o.err, HasSubstr("the table of observe.mean_squared_displacement is \"mean_squared_displacement.csv\" (output.events is written there)"));
}

TEST(RunOutput, that_outgrows_its_disk_never_looks_whole) {
  const Folder folder;
  folder.write("a.toml", test::head_on(2, "[output]\nevents = \"e.csv\"\ntrajectory_frames = \"events\"\n"));
  std::vector<std::string> names{"t.csv", "t.xyz"};
  if (is_built(TrajectoryFormat::h5md)) names.push_back("t.h5");
  for (const std::string& name : names) {
    folder.write(name, "of a former run");
    const auto [done, said] =
        test::printed_by("cd '" + folder.path().string() + "' && ulimit -f 300 && '" CAROM_PROGRAM "' run a.toml --quiet " +
                         "--until 1e9 --set 'output.trajectory=\"" + name + "\"'; echo status $?");
    EXPECT_TRUE(done);
    EXPECT_THAT(said, testing::AllOf(HasSubstr(name), HasSubstr("File too large"), HasSubstr("status 3"))) << said;
    EXPECT_FALSE(std::filesystem::exists(folder.file(name))) << name;
    EXPECT_TRUE(std::filesystem::exists(folder.file(name + ".part"))) << name;
  }
}

TEST(RunOutput, has_a_frame_for_every_collision_if_asked) {
  const Folder folder;
  folder.write("a.toml", test::head_on(2, "[output]\nevents = \"e.csv\"\ntrajectory = \"t.csv\"\n"
                                          "trajectory_frames = \"events\"\nledger = \"l.csv\"\n"));
  ASSERT_EQ(carom(folder, {"run", "a.toml", "--set", "run.sample_every=0.25"}).status, 0);
  const Csv frames(folder.read("t.csv")), ledger(folder.read("l.csv"));
  std::vector<std::string> times, collisions;
  for (const auto& row : frames.rows)
    if (row.at("ball") == "0") times.push_back(row.at("time"));
  EXPECT_THAT(times, ElementsAre("0", "1", "5", "5", "6")) << "both hits of the faces";
  for (const auto& row : ledger.rows) collisions.push_back(row.at("collisions"));
  EXPECT_THAT(collisions, ElementsAre("0", "1", "2", "3", "3"));
  EXPECT_EQ(ledger.rows.back().at("energy"), "1");
  EXPECT_EQ(ledger.rows.back().at("imbalance"), "0");
}

TEST(RunOutput, in_a_format_that_is_not_built_is_refused_by_name) {
  if (is_built(TrajectoryFormat::h5md)) GTEST_SKIP() << "HDF5 is here";
  const Folder folder;
  folder.write("a.toml", test::head_on(2, "[output]\ntrajectory = \"t.h5\"\n"));
  const test::Outcome o = carom(folder, {"run", "a.toml"});
  EXPECT_EQ(o.status, 2);
  EXPECT_THAT(o.err, testing::AllOf(HasSubstr("output.trajectory"), HasSubstr("HDF5")));
}

}  // namespace
}  // namespace carom
