// Extended XYZ: what carom writes, read back by ASE and by carom.

#include "carom/write/extended_xyz.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "carom/core/error.hpp"
#include "carom/write/frame_reader.hpp"
#include "write/python.hpp"
#include "write/scenes.hpp"
#include "write/text_file.hpp"

namespace carom {
namespace {

using testing::ElementsAre;

/// The frames of a scene at each of some times.
void write_frames(const Scene& scene, const std::string& path, std::initializer_list<double> times) {
  Simulation simulation(scene);
  ExtendedXyz file(path, head_of(scene, simulation));
  for (const double t : times) {
    simulation.advance(Number(t));
    file.write(frame_of(simulation));
  }
  file.finish({});
}

Scene periodic_pair() {
  Scene scene = test::head_on(3);
  scene.space.kind = SpaceKind::periodic;
  scene.space.lower = {-1.0, 0.0, 0.0};
  scene.balls[1].radius = 0.25;
  scene.balls[1].mass = 3.0;
  return scene;
}

TEST(ExtendedXyz, has_the_lines_of_the_format) {
  const test::Folder folder;
  write_frames(test::head_on(2), folder.file("a.xyz"), {0.0, 2.0});
  EXPECT_THAT(test::split(folder.read("a.xyz"), '\n'),
              ElementsAre("2",
                          "Lattice=\"10 0 0 0 10 0 0 0 1\" Origin=\"0 0 -0.5\" pbc=\"F F F\" "
                          "Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1:mass:R:1:id:I:1 Time=0 dimension=2",
                          "H 3.5 5 0 1 0 0 0.5 1 0", "H 6.5 5 0 -1 0 0 0.5 1 1", "2", testing::HasSubstr("Time=2 dimension=2"),
                          "H 3.5 5 0 -1 0 0 0.5 1 0", "H 6.5 5 0 1 0 0 0.5 1 1", ""));
}

// At t = 12, ball 0 has left through x- at t = 7.3 or so: its image counts.
TEST(ExtendedXyz, is_read_back_as_it_was) {
  const test::Folder folder;
  const Scene scene = periodic_pair();
  write_frames(scene, folder.file("a.xyz"), {0.0, 0.7, 12.0});
  const auto reader = read_frames(folder.file("a.xyz"));
  EXPECT_EQ(reader->head().dimension, 3);
  EXPECT_EQ(reader->head().space, SpaceKind::periodic);
  EXPECT_THAT(reader->head().lower, ElementsAre(-1, 0, 0));
  EXPECT_THAT(reader->head().upper, ElementsAre(10, 10, 10));
  Simulation simulation(scene);
  TrajectoryFrame frame;
  bool wrapped = false;
  for (const double t : {0.0, 0.7, 12.0}) {
    simulation.advance(Number(t));
    ASSERT_TRUE(reader->next(frame));
    EXPECT_EQ(frame.time.value, t);
    ASSERT_EQ(frame.balls.size(), 2U);
    for (std::uint32_t i = 0; i < 2; ++i) {
      const BallState b = simulation.ball(i);
      EXPECT_EQ(std::vector<double>(frame.balls[i].position.begin(), frame.balls[i].position.end()),
                std::vector<double>(b.position.begin(), b.position.end()));
      EXPECT_EQ(std::vector<double>(frame.balls[i].velocity.begin(), frame.balls[i].velocity.end()),
                std::vector<double>(b.velocity.begin(), b.velocity.end()));
      EXPECT_EQ(frame.balls[i].image, b.image);
      EXPECT_EQ(frame.balls[i].radius.value, b.radius.value);
      EXPECT_EQ(frame.balls[i].mass.value, b.mass.value);
      wrapped = wrapped || b.image[0] != 0;
    }
  }
  EXPECT_TRUE(wrapped);
  EXPECT_FALSE(reader->next(frame));
}

TEST(ExtendedXyz, is_read_by_ase) {
  const auto python = test::python_with("ase");
  if (!python) GTEST_SKIP() << "no python3-ase here";
  const test::Folder folder;
  write_frames(periodic_pair(), folder.file("a.xyz"), {0.0, 0.5});
  folder.write("read.py", R"(
import ase.io
frames = ase.io.read("a.xyz", index=":")
assert len(frames) == 2
last = frames[1]
assert last.pbc.all() and (last.cell.lengths() == [11, 10, 10]).all(), last.cell
assert (last.positions == [[4, 5, 5], [6, 5, 5]]).all(), last.positions
assert (last.arrays["velo"] == [[1, 0, 0], [-1, 0, 0]]).all()
assert (last.arrays["radius"] == [0.5, 0.25]).all() and (last.arrays["mass"] == [1, 3]).all()
assert last.info["Time"] == 0.5
assert last.get_chemical_symbols() == ["H", "He"]
)");
  const auto [read, said] = test::printed_by("cd '" + folder.path().string() + "' && " + *python + " read.py");
  EXPECT_TRUE(read) << said;
}

TEST(ExtendedXyz, of_other_programs_is_taken_by_its_keys) {
  const test::Folder folder;
  folder.write("a.xyz",
               "2\nProperties=id:I:1:species:S:1:pos:R:3:vel:R:3 Lattice=\"5 0 0 0 6 0 0 0 7\" comment='x=1 y' Time=1.5\n"
               "12 Ar 1 2 3 0.1 0.2 0.3\n10 Ar 4 5 6.000 0 0 0\n");
  const auto reader = read_frames(folder.file("a.xyz"));
  EXPECT_EQ(reader->head().space, SpaceKind::periodic);
  EXPECT_TRUE(reader->head().velocities);
  EXPECT_FALSE(reader->head().radii);
  TrajectoryFrame frame;
  ASSERT_TRUE(reader->next(frame));
  EXPECT_EQ(frame.time.value, 1.5);
  EXPECT_EQ(frame.balls[0].position[2].value, 3.0);
  EXPECT_EQ(frame.balls[1].position[2].text, "6.000");
}

TEST(ExtendedXyz, that_is_wrong_is_refused_with_its_line) {
  const test::Folder folder;
  const auto problem = [&](const std::string& text) {
    folder.write("a.xyz", text);
    try {
      static_cast<void>(survey(folder.file("a.xyz")));
    } catch (const InputError& error) {
      return error.problems().front().text().substr(folder.path().string().size() + 1);
    }
    return std::string("accepted");
  };
  EXPECT_THAT(problem("2\n\nH 0 0 0\n"), testing::HasSubstr("a.xyz:3: the frame ends early"));
  EXPECT_THAT(problem("1\n\nH 0 x 0\n"), testing::HasSubstr("a.xyz:3: \"x\" is no number"));
  EXPECT_THAT(problem("1\nLattice=\"1 0 0 0.5 1 0 0 0 1\"\nH 0 0 0\n"), testing::HasSubstr("a.xyz:2: the cell is not a box"));
  EXPECT_THAT(problem("1\nProperties=species:S:1\nH\n"), testing::HasSubstr("pos:R:3"));
  EXPECT_THAT(problem("two\n\n"), testing::HasSubstr("a.xyz:1"));
}

}  // namespace
}  // namespace carom
