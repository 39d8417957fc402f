// H5MD: what carom writes, checked against the specification by h5py, and read back by carom.

#include "carom/write/trajectory.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "carom/core/error.hpp"
#include "carom/write/frame_reader.hpp"
#include "carom/write/number_text.hpp"
#include "carom/write/output_file.hpp"
#include "write/python.hpp"
#include "write/scenes.hpp"
#include "write/text_file.hpp"

namespace carom {
namespace {

/// A gas of disks of two kinds in a periodic square.
Scene gas() {
  Scene scene;
  scene.space.kind = SpaceKind::periodic;
  scene.space.lower = {-3.0, -3.0};
  scene.space.upper = {7.0, 7.0};
  for (const double radius : {0.5, 0.3}) {
    GasSpec g;
    g.count = 10;
    g.radius = radius;
    g.mass = radius;
    scene.gases.push_back(g);
  }
  scene.run.until = 10.0;
  return scene;
}

/// Writes a frame at the start and after each of `events` collisions.
Summary write_events(const Scene& scene, const std::string& path, int events) {
  Simulation simulation(scene);
  const auto file = begin_trajectory(path, head_of(scene, simulation), {"the = \"scene\"\n", {"run.until=3"}, ""});
  file->write(frame_of(simulation, Books::kept));
  for (int k = 0; k < events; ++k) {
    simulation.advance(std::nullopt, 1);
    file->write(frame_of(simulation, Books::kept));
  }
  const Summary summary = simulation.summary();
  file->finish({"events", summary});
  return summary;
}

class H5mdFile : public testing::Test {
 protected:
  void SetUp() override {
    if (!is_built(TrajectoryFormat::h5md)) GTEST_SKIP() << "carom was built without HDF5";
  }

  /// What tests/write/check_h5md.py says of a file of this test.
  void check(const std::string& file, const std::string& more = "") {
    const auto python = test::python_with("h5py");
    if (!python) GTEST_SKIP() << "no python3-h5py here";
    const auto [good, said] =
        test::printed_by(*python + " " CAROM_SOURCE_DIR "/tests/write/check_h5md.py '" + folder.file(file) + "' " + more);
    EXPECT_TRUE(good) << said;
  }
  /// A few lines of Python on the open file f.
  void read(const std::string& file, const std::string& lines) {
    const auto python = test::python_with("h5py");
    if (!python) GTEST_SKIP() << "no python3-h5py here";
    folder.write("read.py", "import h5py, numpy, sys\nf = h5py.File(sys.argv[1], 'r')\n" + lines);
    const auto [good, said] = test::printed_by(*python + " '" + folder.file("read.py") + "' '" + folder.file(file) + "'");
    EXPECT_TRUE(good) << said;
  }

  const test::Folder folder;
};

TEST_F(H5mdFile, conforms_and_shows_balls_that_touch) {
  write_events(gas(), folder.file("gas.h5"), 600);  // more rows than a chunk holds
  check("gas.h5", "contacts");
  write_events(test::head_on(3), folder.file("box.h5"), 2);
  check("box.h5", "contacts");
}

TEST_F(H5mdFile, has_the_ledger_and_where_it_comes_from) {
  const Summary s = write_events(gas(), folder.file("gas.h5"), 30);
  EXPECT_THAT(folder.files(), testing::ElementsAre("gas.h5"));
  read("gas.h5", "p = f['parameters']\nledger = p['ledger'].attrs\n"
                 "assert ledger['ball_ball'] == 30 and ledger['energy_final'] == " + number_text(s.energy.final) + "\n"
                 "assert p.attrs['stopped_by'] == b'events' and b'heap' in p.attrs['composition'], dict(p.attrs)\n"
                 "assert p['scene'][()] == b'the = \"scene\"\\n' and p['settings'][()] == b'run.until=3\\n'\n"
                 "energy = f['observables/total_energy/value'][:]\n"
                 "assert abs(energy / energy[0] - 1).max() < 1e-14\n"
                 "v, m = f['particles/all/velocity/value'][:], f['particles/all/mass'][:]\n"
                 "assert abs((m[:, None] * v**2).sum(axis=(1, 2)) / 2 / energy - 1).max() < 1e-14\n"
                 "assert (f['particles/all/species'][:] == [0] * 10 + [1] * 10).all()\n");
}

// Three balls on a line that merge one by one: 1 into 0, then 2 into 0.
TEST_F(H5mdFile, marks_balls_that_have_left) {
  Scene scene;
  scene.dimension = 1;
  scene.collision.law = LawKind::merge;
  for (const double x : {0.0, 2.0, 5.0}) scene.balls.push_back({.position = {x}, .velocity = {x == 0.0 ? 1.0 : 0.0}});
  scene.run.until = 100.0;
  write_events(scene, folder.file("merge.h5"), 2);
  check("merge.h5");
  read("merge.h5", "a = f['particles/all']\n"
                   "assert (a['id/value'][:] == [[0, 1, 2], [0, -1, 2], [0, -1, -1]]).all(), a['id/value'][:]\n"
                   "assert a['id/value'].fillvalue == -1\n"
                   "assert (a['mass/value'][:, 0] == [1, 2, 3]).all()\n"
                   "assert numpy.isnan(a['position/value'][2, 1:]).all() and 'species' not in a\n");
  const auto reader = read_frames(folder.file("merge.h5"));
  TrajectoryFrame frame;
  for (const std::size_t left : {3U, 2U, 1U}) {
    ASSERT_TRUE(reader->next(frame));
    EXPECT_EQ(frame.balls.size(), left);
  }
  EXPECT_EQ(frame.balls[0].mass.value, 3.0);
}

TEST_F(H5mdFile, is_read_back_as_it_was) {
  const Scene scene = gas();
  write_events(scene, folder.file("gas.h5"), 40);
  const auto reader = read_frames(folder.file("gas.h5"));
  EXPECT_EQ(reader->head().space, SpaceKind::periodic);
  EXPECT_THAT(reader->head().upper, testing::ElementsAre(7, 7, 0));
  Simulation simulation(scene);
  TrajectoryFrame frame;
  for (int k = 0; k <= 40; ++k) {
    if (k > 0) simulation.advance(std::nullopt, 1);
    ASSERT_TRUE(reader->next(frame));
    EXPECT_EQ(frame.time.value, simulation.time().value);
    for (std::uint32_t i = 0; i < 20; ++i) {
      const BallState b = simulation.ball(i);
      EXPECT_EQ(frame.balls[i].position[1].value, b.position[1].value);
      EXPECT_EQ(frame.balls[i].velocity[0].value, b.velocity[0].value);
      EXPECT_EQ(frame.balls[i].image, b.image);
      EXPECT_EQ(frame.balls[i].radius.value, b.radius.value);
    }
  }
  EXPECT_FALSE(reader->next(frame));
  EXPECT_EQ(reader->stopped_by(), "events");
}

TEST_F(H5mdFile, of_no_frames_or_of_another_format_is_refused) {
  folder.write("a.h5", "this is no HDF5");
  EXPECT_THROW(static_cast<void>(read_frames(folder.file("a.h5"))), InputError);
  EXPECT_THROW(static_cast<void>(read_frames(folder.file("none.h5"))), InputError);
}

TEST_F(H5mdFile, that_cannot_be_made_says_why) {
  const Scene scene = test::head_on(2);
  const Simulation simulation(scene);
  try {
    static_cast<void>(begin_trajectory(folder.file("none/a.h5"), head_of(scene, simulation), {}));
    FAIL() << "made a file in a folder that is not there";
  } catch (const OutputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("No such file or directory"));
  }
}

TEST(Trajectory, of_an_unknown_ending_is_refused) {
  EXPECT_THROW(require_built("a.dat"), InputError);
  EXPECT_NO_THROW(require_built("a.xyz"));
  EXPECT_EQ(trajectory_format("a.h5"), TrajectoryFormat::h5md);
}

}  // namespace
}  // namespace carom
