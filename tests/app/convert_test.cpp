// carom convert: trajectories into one another, and snapshots into scenes that run.

#include "app/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "carom/write/trajectory.hpp"

namespace carom {
namespace {

using nlohmann::json;
using test::carom;
using test::Folder;
using testing::HasSubstr;

const std::string frames = "sample_every = 0.7\n[output]\ntrajectory = \"t.csv\"\n";

TEST(Convert, goes_round_without_a_change) {
  const Folder folder;
  folder.write("a.toml", test::head_on(2, frames));
  ASSERT_EQ(carom(folder, {"run", "a.toml"}).status, 0);
  const std::string first = folder.read("t.csv");
  std::vector<std::string> names{"t.csv", "u.xyz", "v.csv"};
  if (is_built(TrajectoryFormat::h5md)) names = {"t.csv", "u.xyz", "u.h5", "v.csv"};
  for (std::size_t k = 1; k < names.size(); ++k) {
    const test::Outcome o = carom(folder, {"convert", names[k - 1], "-o", names[k]});
    EXPECT_EQ(o.status, 0) << o.err;
    EXPECT_EQ(o.out, "Wrote " + names[k] + ": 10 frames of 2 balls.\n");
  }
  const test::Csv before(first), after(folder.read("v.csv"));
  EXPECT_EQ(before.header, after.header);
  EXPECT_EQ(before.rows, after.rows);
}

TEST(Convert, makes_a_scene_that_goes_on_where_the_frame_was) {
  const Folder folder;
  folder.write("a.toml", test::head_on(3, frames));
  ASSERT_EQ(carom(folder, {"run", "a.toml"}).status, 0);
  ASSERT_EQ(carom(folder, {"convert", "t.csv", "--to", "toml", "--frame", "0"}).status, 0);
  const auto final = [&](const std::string& scene) {
    return json::parse(carom(folder, {"run", scene, "--until", "6", "--events", "1000", "--final", "--json"}).out)["final"];
  };
  const json there = final("a.toml"), again = final("t.toml");
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(there[i]["position"], again[i]["position"]);
    EXPECT_EQ(there[i]["velocity"], again[i]["velocity"]);
  }
  EXPECT_EQ(carom(folder, {"convert", "t.csv", "--to", "toml"}).status, 2) << "a scene is not overwritten";
  EXPECT_EQ(carom(folder, {"convert", "t.csv", "-o", "b.toml", "--frame", "10"}).status, 2) << "there is no such frame";
}

// The format of EDMD: spheres may have left the box. Velocities are drawn: k_B T = 2 E / (3 (N - 1)).
TEST(Convert, takes_snapshots_of_edmd) {
  const Folder folder;
  folder.write("s.sph",
               "3\n5 6 7.000\na 1 1 1  0.5\nb -0.25 3.123456789012 2 0.5\na 7 1 6.5 0.25\n"
               "3\n5 6 7.000\na 1.5 1 1  0.5\nb -0.25 3.123456789012 2 0.5\na 7 1 6.5 0.25\n");
  const test::Outcome o = carom(folder, {"convert", "s.sph", "--temperature", "2", "--seed", "4"});
  ASSERT_EQ(o.status, 0) << o.err;
  const std::string scene = folder.read("s.toml");
  EXPECT_THAT(scene, testing::AllOf(HasSubstr("upper = [5, 6, 7]"), HasSubstr("position = [1.5, 1, 1]"),
                                    HasSubstr("position = [-0.25, 3.123456789012, 2]"), HasSubstr("radius = 0.25"),
                                    HasSubstr("k_B T = 2 with seed 4")));
  const json j = json::parse(carom(folder, {"run", "s.toml", "--events", "50", "--json"}).out);
  EXPECT_EQ(j["events"]["ball_ball"], 50);
  EXPECT_NEAR(2 * j["energy"]["initial"].get<double>() / (3 * 2), 2.0, 1e-13);
}

TEST(Convert, asks_for_the_radii_that_a_file_has_not) {
  const Folder folder;
  folder.write("a.xyz", "1\nLattice=\"5 0 0 0 5 0 0 0 5\" Properties=species:S:1:pos:R:3:velo:R:3\nAr 1 2 3 0.5 0 0\n");
  const test::Outcome asked = carom(folder, {"convert", "a.xyz"});
  EXPECT_EQ(asked.status, 2);
  EXPECT_THAT(asked.err, HasSubstr("--radius"));
  ASSERT_EQ(carom(folder, {"convert", "a.xyz", "--radius", "0.3"}).status, 0);
  EXPECT_THAT(folder.read("a.toml"), testing::AllOf(HasSubstr("radius = 0.3"), HasSubstr("velocity = [0.5, 0, 0]")));
}

TEST(Convert, says_what_it_cannot_read) {
  const Folder folder;
  folder.write("a.toml", test::head_on(2, "[output]\nevents = \"e.csv\"\n"));
  ASSERT_EQ(carom(folder, {"run", "a.toml"}).status, 0);
  EXPECT_THAT(carom(folder, {"convert", "e.csv", "--to", "xyz"}).err, HasSubstr("output.trajectory"));
  EXPECT_THAT(carom(folder, {"convert", "none.csv", "--to", "xyz"}).err, HasSubstr("No such file"));
  EXPECT_THAT(carom(folder, {"convert", "a.dat", "--to", "xyz"}).err, HasSubstr(".sph"));
  folder.write("cut.csv", "# dimension: 1\ntime,ball,x,radius,mass\n0,0,1,0.5,1\n0,1,3,0.5,1\n");
  const test::Outcome cut = carom(folder, {"convert", "cut.csv", "--to", "xyz"});
  EXPECT_EQ(cut.status, 0);
  EXPECT_THAT(cut.err, HasSubstr("cut off"));
}

}  // namespace
}  // namespace carom
