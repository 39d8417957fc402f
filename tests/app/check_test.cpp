// carom check, and checkpoints: what the program says of a run, and how it goes on with one.

#include "app/program.hpp"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace carom {
namespace {

using nlohmann::json;
using test::carom;
using test::Folder;
using testing::HasSubstr;

// 40 disks in a periodic cell: nothing but collisions of two balls.
const char* const gas =
    "dimension = 2\n[space]\nkind = \"periodic\"\nlower = [0, 0]\nupper = [10, 10]\n[[gas]]\ncount = 40\npacking_fraction "
    "= 0.4\n"
    "[run]\nevents = 4000\n[output]\nevents = \"log.csv\"\n";

json parsed(const test::Outcome& o) { return json::parse(o.out); }

/// The lines of collisions in an event log.
std::vector<std::string> lines(const Folder& folder) {
  std::vector<std::string> all;
  std::istringstream text(folder.read("log.csv"));
  for (std::string line; std::getline(text, line);)
    if (!line.empty() && line[0] != '#' && line[0] != 't') all.push_back(line);
  return all;
}

TEST(Check, reports_what_it_found) {
  const Folder folder;
  folder.write("gas.toml", gas);
  const test::Outcome o = carom(folder, {"check", "gas.toml", "--events", "500", "--audits", "50", "--json"});
  ASSERT_EQ(o.status, 0) << o.err;
  const json j = parsed(o);
  EXPECT_EQ(j["events"], 500);
  EXPECT_EQ(j["audit"]["overlaps"], 0);
  EXPECT_GE(j["audit"]["audits"], 50);
  EXPECT_EQ(j["same_log"], true);
  EXPECT_LE(j["energy"], 1e-14);
  EXPECT_TRUE(j["echo_error"].is_number());
  EXPECT_NE(j["composition"], j["reference"]);
  EXPECT_FALSE(std::filesystem::exists(folder.file("log.csv"))) << "check writes no files";
  EXPECT_THAT(carom(folder, {"check", "gas.toml", "--events", "100"}).out, HasSubstr("bit for bit"));
}

// Two balls that meet once and fly on: turned round they come back to rounding.
TEST(Check, echo_of_a_short_run_is_rounding) {
  const Folder folder;
  folder.write("a.toml", test::head_on(2));
  EXPECT_LE(parsed(carom(folder, {"check", "a.toml", "--json"}))["echo_error"], 1e-14);
  EXPECT_TRUE(
      parsed(carom(folder, {"check", "a.toml", "--json", "--set", "collision.restitution=0.5"}))["echo_error"].is_null());
}

TEST(Check, refuses_a_wrong_scene_and_reports_a_collapse) {
  const Folder folder;
  EXPECT_EQ(carom(folder, {"check", "missing.toml"}).status, 2);
  folder.write("b.toml",
               "dimension = 1\n[motion]\nacceleration = [-1]\n[collision]\nrestitution = 0.5\n[[ball]]\nposition = [2]\n"
               "[[wall]]\nkind = \"plane\"\npoint = [0]\nnormal = [1]\n[run]\nuntil = 100\n");
  const test::Outcome o = carom(folder, {"check", "b.toml"});
  EXPECT_EQ(o.status, 3);
  EXPECT_THAT(o.err, HasSubstr("infinitely many"));
}

TEST(Resume, goes_on_bit_for_bit) {
  const Folder folder;
  folder.write("gas.toml", gas);
  ASSERT_EQ(carom(folder, {"run", "gas.toml", "--quiet"}).status, 0);
  const std::vector<std::string> whole = lines(folder);
  ASSERT_EQ(whole.size(), 4000u);

  ASSERT_EQ(carom(folder, {"run", "gas.toml", "--quiet", "--events", "1500", "--checkpoint", "at.carom"}).status, 0);
  const std::vector<std::string> first = lines(folder);
  EXPECT_FALSE(std::filesystem::exists(folder.file("at.carom.part")));
  for (const char* search : {"cells", "all_pairs"}) {
    const test::Outcome o = carom(
        folder, {"run", "gas.toml", "--resume", "at.carom", "--json", "--set", std::string("engine.search=") + search});
    ASSERT_EQ(o.status, 0) << o.err;
    EXPECT_EQ(parsed(o)["events"]["ball_ball"], 4000) << "counts go on";
    std::vector<std::string> joined = first;
    for (const std::string& line : lines(folder)) joined.push_back(line);
    EXPECT_EQ(joined, whole) << search;
  }
}

TEST(Resume, refuses_what_is_no_checkpoint_of_this_scene) {
  const Folder folder;
  folder.write("gas.toml", gas);
  folder.write("other.toml", test::head_on(2));
  ASSERT_EQ(carom(folder, {"run", "gas.toml", "--quiet", "--events", "10", "--checkpoint", "at.carom"}).status, 0);
  std::filesystem::remove(folder.file("log.csv"));
  EXPECT_THAT(carom(folder, {"run", "other.toml", "--resume", "at.carom"}).err, HasSubstr("another scene"));
  EXPECT_THAT(carom(folder, {"run", "gas.toml", "--resume", "gas.toml"}).err, HasSubstr("no checkpoint of carom"));
  EXPECT_THAT(carom(folder, {"run", "gas.toml", "--resume", "nothing"}).err, HasSubstr("cannot read the checkpoint"));
  std::filesystem::resize_file(folder.file("at.carom"), std::filesystem::file_size(folder.file("at.carom")) - 1);
  const test::Outcome o = carom(folder, {"run", "gas.toml", "--resume", "at.carom"});
  EXPECT_EQ(o.status, 2);
  EXPECT_THAT(o.err, HasSubstr("damaged"));
  EXPECT_FALSE(std::filesystem::exists(folder.file("log.csv"))) << "nothing was written";
}

TEST(Checkpoint, is_kept_as_the_scene_asks) {
  const Folder folder;
  folder.write("gas.toml", std::string(gas) + "checkpoint = { every = { events = 1000 } }\n");
  ASSERT_EQ(carom(folder, {"run", "gas.toml", "--quiet", "--out", "o"}).status, 0);
  EXPECT_TRUE(std::filesystem::exists(folder.file("o/checkpoint.carom")));
  const test::Outcome unwritable = carom(folder, {"run", "gas.toml", "--quiet", "--checkpoint", "no/such/folder/c"});
  EXPECT_EQ(unwritable.status, 3);
  EXPECT_THAT(unwritable.err, HasSubstr("cannot write the checkpoint"));
  EXPECT_EQ(carom(folder, {"run", "gas.toml", "--set", "output.checkpoint.every.time=-1"}).status, 2);
}

}  // namespace
}  // namespace carom
