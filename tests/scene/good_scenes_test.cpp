// Scenes that are right: every key arrives in its field, numbers keep their text.

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "carom/core/rational.hpp"
#include "carom/scene/read.hpp"
#include "carom/scene/validate.hpp"
#include "full_scene.hpp"

namespace carom {
namespace {

using testing::full_scene;
using testing::small_scene;

std::vector<double> values(const Coordinates& v) { return {v.begin(), v.end()}; }
using Values = std::vector<double>;

Scene full() {
  scene_text::Reading r = testing::reading(full_scene);
  EXPECT_TRUE(testing::mistakes(r.problems).empty()) << testing::listed(r.problems);
  return std::move(r.scene);
}

TEST(GoodScenes, a_short_one_has_the_defaults) {
  const Scene s = read_scene(small_scene, "test.toml");
  EXPECT_EQ(s.file, "test.toml");
  EXPECT_EQ(s.dimension, 2);
  EXPECT_EQ(s.space.kind, SpaceKind::open);
  ASSERT_EQ(s.balls.size(), 2u);
  EXPECT_EQ(s.balls[0].radius.value, 0.5);
  EXPECT_EQ(s.balls[0].mass.value, 1.0);
  EXPECT_TRUE(s.balls[1].velocity.empty());
  EXPECT_EQ(s.balls[1].where.line, 4);
  EXPECT_EQ(s.run.until->value, 10.0);
  EXPECT_FALSE(s.run.events);
  EXPECT_EQ(s.collision.restitution.value, 1.0);
  EXPECT_EQ(s.engine.queue, QueueKind::automatic);
}

TEST(GoodScenes, space_motion_and_collision_arrive) {
  const Scene s = full();
  EXPECT_EQ(s.title, "Every key – of a scene");
  EXPECT_EQ(s.space.kind, SpaceKind::box);
  EXPECT_EQ(values(s.space.lower), (Values{0, -1}));
  EXPECT_EQ(values(s.space.upper), (Values{20.0 / 3.0, 10}));
  EXPECT_EQ(s.space.restitution->value, 0.9);
  EXPECT_EQ(s.space.where.line, 4);
  EXPECT_EQ(values(s.motion.acceleration), (Values{0, -9.81}));
  EXPECT_EQ(s.collision.restitution.value, 0.8);
  ASSERT_EQ(s.materials.size(), 2u);
  EXPECT_EQ(s.materials[0].name, "ivory");
  EXPECT_EQ(s.materials[1].restitution.value, 0.5);
  ASSERT_EQ(s.material_pairs.size(), 1u);
  EXPECT_EQ(s.material_pairs[0].first, "ivory");
  EXPECT_EQ(s.material_pairs[0].second, "rubber");
  EXPECT_EQ(s.material_pairs[0].restitution.value, 0.75);
}

TEST(GoodScenes, balls_lattices_and_gases_arrive) {
  const Scene s = full();
  ASSERT_EQ(s.balls.size(), 2u);
  EXPECT_EQ(s.balls[0].name, "cue");
  EXPECT_EQ(s.balls[0].where.line, 27);
  EXPECT_EQ(values(s.balls[0].velocity), (Values{3, 1.05}));
  EXPECT_EQ(s.balls[0].mass.value, std::numeric_limits<double>::infinity());
  EXPECT_EQ(s.balls[0].material, "ivory");
  EXPECT_EQ(values(s.balls[1].position), (Values{4, 5}));
  EXPECT_TRUE(s.balls[1].fixed);

  ASSERT_EQ(s.lattices.size(), 2u);
  EXPECT_EQ(s.lattices[0].kind, LatticeKind::hexagonal);
  EXPECT_EQ(s.lattices[0].count, 72);
  EXPECT_EQ(s.lattices[0].packing_fraction->value, 0.7);
  EXPECT_EQ(s.lattices[0].radius->value, 0.25);
  EXPECT_EQ(s.lattices[0].mass.value, 2.0);
  EXPECT_EQ(s.lattices[0].material, "rubber");
  EXPECT_EQ(s.lattices[0].temperature->value, 1.5);
  EXPECT_EQ(s.lattices[0].seed, 7u);
  EXPECT_EQ(s.lattices[1].kind, LatticeKind::rack);
  EXPECT_EQ(s.lattices[1].rows, 3);
  EXPECT_EQ(s.lattices[1].gap.value, 0.001);
  EXPECT_EQ(values(s.lattices[1].apex), (Values{2, 2}));
  EXPECT_EQ(values(s.lattices[1].direction), (Values{0, 1}));

  ASSERT_EQ(s.gases.size(), 1u);
  EXPECT_EQ(s.gases[0].count, 10000);
  EXPECT_EQ(s.gases[0].packing_fraction->value, 0.3);
  EXPECT_EQ(s.gases[0].radius->value, 0.5);
  EXPECT_EQ(s.gases[0].mass.value, 3.0);
  EXPECT_EQ(s.gases[0].temperature.value, 2.0);
  EXPECT_EQ(s.gases[0].material, "ivory");
  EXPECT_EQ(s.gases[0].seed, 9u);
}

TEST(GoodScenes, walls_arrive) {
  const Scene s = full();
  ASSERT_EQ(s.walls.size(), 4u);
  EXPECT_EQ(s.walls[0].kind, WallKind::segment);
  EXPECT_EQ(values(s.walls[0].from), (Values{0, 0}));
  EXPECT_EQ(values(s.walls[0].to), (Values{4, 3}));
  EXPECT_EQ(values(s.walls[0].velocity), (Values{0, 1}));
  EXPECT_EQ(s.walls[0].restitution->value, 0.6);
  EXPECT_EQ(s.walls[1].kind, WallKind::plane);
  EXPECT_EQ(values(s.walls[1].point), (Values{1, 0}));
  EXPECT_EQ(values(s.walls[1].normal), (Values{0, 1}));
  EXPECT_EQ(s.walls[1].material, "rubber");
  EXPECT_EQ(s.walls[2].kind, WallKind::circle);
  EXPECT_EQ(values(s.walls[2].centre), (Values{5, 5}));
  EXPECT_EQ(s.walls[2].radius.value, 4.0);
  EXPECT_EQ(s.walls[2].side, WallSide::outside);
  EXPECT_EQ(s.walls[3].kind, WallKind::polygon);
  ASSERT_EQ(s.walls[3].vertices.size(), 3u);
  EXPECT_EQ(exact(s.walls[3].vertices[2][1]), Rational(1, 7));
}

TEST(GoodScenes, run_engine_observe_and_output_arrive) {
  const Scene s = full();
  EXPECT_EQ(s.run.start.value, -1.0);
  EXPECT_EQ(s.run.until->value, 10.0);
  EXPECT_EQ(s.run.events, 1'000'000);
  EXPECT_EQ(s.run.sample_every->value, 0.1);
  EXPECT_EQ(s.run.seed, 5u);
  EXPECT_EQ(s.engine.search, SearchKind::cells);
  EXPECT_EQ(s.engine.queue, QueueKind::heap);
  EXPECT_EQ(s.observe.after_events, 100000);
  EXPECT_TRUE(s.observe.pressure && s.observe.collision_rate && s.observe.mean_free_path && s.observe.speed_histogram);
  EXPECT_EQ(s.observe.lyapunov->exponents, 3);
  EXPECT_EQ(s.observe.lyapunov->every->value, 0.5);
  EXPECT_EQ(s.observe.lyapunov->finite_time->value, 2.0);
  EXPECT_EQ(s.observe.boundary_map->file, "map.csv");
  EXPECT_EQ(values(s.observe.poincare->point), (Values{1, 2}));
  EXPECT_EQ(values(s.observe.poincare->normal), (Values{0, 1}));
  EXPECT_EQ(s.observe.poincare->file, "section.csv");
  EXPECT_TRUE(s.observe.wall_sequence && s.observe.rotation_number && s.observe.caustic);
  EXPECT_EQ(s.observe.phase_space_portion->bins, 50);
  EXPECT_EQ(s.observe.diffusion->lags, 20);
  EXPECT_EQ(s.observe.diffusion->origins, 5);
  EXPECT_EQ(s.observe.angle_autocorrelation->every->value, 0.25);
  EXPECT_FALSE(s.observe.survival);
  EXPECT_EQ(s.output.events, "events.csv");
  EXPECT_EQ(s.output.trajectory, "trajectory.csv");
  EXPECT_EQ(s.output.trajectory_frames, FramesAt::events);
  EXPECT_EQ(s.output.ledger, "ledger.csv");
}

TEST(GoodScenes, a_read_scene_passes_the_rules_for_code) {
  EXPECT_TRUE(validate(read_scene(small_scene, "test.toml")).empty());
}

TEST(GoodScenes, numbers_keep_the_text_that_was_written) {
  const Scene s = full();
  EXPECT_EQ(s.balls[0].position[0].text, "0.1");
  EXPECT_EQ(exact(s.balls[0].position[0]), Rational(1, 10));
  EXPECT_EQ(exact(s.balls[0].position[1]), Rational(5, 2));
  EXPECT_EQ(exact(s.balls[0].velocity[1]), Rational(105, 100));
  EXPECT_EQ(exact(s.balls[0].radius), Rational(1, 3));
  EXPECT_EQ(exact(s.balls[1].position[0]), Rational(4));
  EXPECT_EQ(exact(s.balls[1].position[1]), Rational(5));
  EXPECT_EQ(exact(s.space.upper[1]), Rational(10));
  EXPECT_EQ(exact(s.lattices[1].gap), Rational(1, 1000));
}

TEST(GoodScenes, texts_are_found_wherever_they_stand) {
  // A byte order mark, CRLF, letters of 2 to 4 bytes before the number, tabs, dotted keys, inline tables.
  const std::string text =
      "\xEF\xBB\xBFrun.until = 0.3 # first line\r\n"
      "ball = [ { name = \"\xC3\xA9 \xE2\x82\xAC \xF0\x9D\x84\x9E\", position = [\t0.7,\r\n 0.1 ] }, { position = [3.30, "
      "5] } ]\r\n";
  const Scene s = read_scene(text, "test.toml");
  EXPECT_EQ(exact(*s.run.until), Rational(3, 10));
  EXPECT_EQ(exact(s.balls[0].position[0]), Rational(7, 10));
  EXPECT_EQ(exact(s.balls[0].position[1]), Rational(1, 10));
  EXPECT_EQ(s.balls[1].position[0].text, "3.30");
}

TEST(GoodScenes, every_dimension_and_infinite_mass_as_a_literal) {
  for (const std::string dimension : {"1", "2", "3"}) {
    const std::string position = dimension == "1" ? "[0.5]" : dimension == "2" ? "[0.5, 1]" : "[0.5, 1, 2]";
    const Scene s =
        read_scene("dimension = " + dimension + "\n[[ball]]\nmass = inf\nposition = " + position + "\n[run]\nevents = 3\n",
                   "test.toml");
    EXPECT_EQ(std::to_string(s.dimension), dimension);
    EXPECT_EQ(std::to_string(s.balls[0].position.size()), dimension);
    EXPECT_EQ(s.balls[0].mass.value, std::numeric_limits<double>::infinity());
  }
}

TEST(GoodScenes, a_file_is_read_like_a_text) {
  const std::filesystem::path path = std::filesystem::path(::testing::TempDir()) / "carom_good_scene.toml";
  std::ofstream(path) << small_scene;
  const Scene s = read_scene_file(path.string(), {{"run.until", "2.5"}});
  EXPECT_EQ(s.file, path.string());
  EXPECT_EQ(s.balls.size(), 2u);
  EXPECT_EQ(s.run.until->value, 2.5);
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace carom
