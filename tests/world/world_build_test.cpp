// From a scene to a world: what is refused and why, what starts in contact, which units are chosen.

#include "carom/world/build.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "carom/core/error.hpp"
#include "carom/scene/read.hpp"
#include "sim/scenes.hpp"

namespace carom {
namespace {

using namespace testing;
using ::testing::HasSubstr;

std::vector<Problem> problems_of(const Scene& scene) {
  try {
    (void)Simulation(scene);
  } catch (const InputError& e) {
    return e.problems();
  }
  return {};
}

Scene read(const std::string& text) { return read_scene(text, "scene.toml"); }

// Refusals.

TEST(Refused, overlapping_balls_with_their_names_the_depth_and_the_line) {
  const auto problems = problems_of(read(R"(dimension = 2
[run]
until = 1
[[ball]]
name = "cue"
position = [0, 0]
[[ball]]
position = [0.75, 0]
[[ball]]
position = [5, 0]
[[ball]]
position = [5, 0.875]
)"));
  ASSERT_EQ(problems.size(), 2u) << "every problem, not only the first";
  EXPECT_EQ(problems[0].file, "scene.toml");
  EXPECT_EQ(problems[0].line, 7) << "where the second of the two stands";
  EXPECT_THAT(problems[0].what, HasSubstr("ball 0 (\"cue\") and ball 1 overlap by 0.25"));
  EXPECT_EQ(problems[1].line, 11);
  EXPECT_THAT(problems[1].what, HasSubstr("ball 2 and ball 3 overlap by 0.125"));
  for (const Problem& p : problems) {
    EXPECT_FALSE(p.why.empty());
    EXPECT_FALSE(p.hint.empty());
  }
}

TEST(Refused, balls_outside_the_box_or_across_its_faces) {
  Scene scene = box({0.0, 0.0}, {10.0, 10.0});
  scene.balls = {ball({0.25, 5.0}, {}), ball({5.0, 9.75}, {}), ball({-20.0, 5.0}, {}), ball({5.0, 5.0}, {})};
  const auto problems = problems_of(scene);
  ASSERT_EQ(problems.size(), 3u);
  EXPECT_THAT(problems[0].what, HasSubstr("ball 0"));
  EXPECT_THAT(problems[0].what, HasSubstr("x-"));
  EXPECT_THAT(problems[0].what, HasSubstr("0.25"));
  EXPECT_THAT(problems[1].what, HasSubstr("y+"));
  EXPECT_THAT(problems[2].what, HasSubstr("ball 2"));
}

TEST(Refused, balls_across_walls) {
  Scene scene = open_space(2);
  scene.walls = {plane({0.0, 0.0}, {0.0, 1.0}), circle({0.0, 5.0}, 3.0, WallSide::inside),
                 circle({0.0, 5.0}, 0.5, WallSide::outside)};
  scene.balls = {ball({0.0, 2.25}, {}), ball({0.0, 5.75}, {}), ball({2.0, 5.0}, {})};
  const auto problems = problems_of(scene);
  ASSERT_EQ(problems.size(), 2u);
  EXPECT_THAT(problems[0].what, HasSubstr("ball 0"));
  EXPECT_THAT(problems[0].what, HasSubstr("0.25"));
  EXPECT_THAT(problems[0].what, HasSubstr("wall 1"));
  EXPECT_THAT(problems[1].what, HasSubstr("ball 1"));
  EXPECT_THAT(problems[1].what, HasSubstr("wall 2"));
  scene.balls = {ball({0.0, 5.0}, {}, 4.0)};
  EXPECT_FALSE(problems_of(scene).empty()) << "too large for the circle";
}

// The smallest overlap that the coordinates can tell is refused, one that they cannot tell is a contact.
TEST(Refused, an_overlap_by_a_few_ulps_but_not_by_half) {
  const auto apart = [](double distance) {
    Scene scene = open_space(2);
    scene.balls = {ball({0.0, 0.0}, {}), ball({distance, 0.0}, {})};
    return scene;
  };
  EXPECT_TRUE(problems_of(apart(1.0)).empty());
  EXPECT_TRUE(problems_of(apart(1.0 - 0x1p-54)).empty());
  EXPECT_FALSE(problems_of(apart(1.0 - 0x1p-50)).empty());
  EXPECT_TRUE(problems_of(apart(1.0 + 0x1p-52)).empty());
}

TEST(Refused, values_beyond_the_range_of_a_scene) {
  const auto with = [](auto&& change) {
    Scene scene = open_space(2);
    scene.balls = {ball({0.0, 0.0}, {1.0, 0.0}), ball({5.0, 0.0}, {})};
    change(scene.balls[1]);
    return problems_of(scene);
  };
  EXPECT_TRUE(with([](BallSpec&) {}).empty());
  for (const int e : {380, -380}) EXPECT_TRUE(with([&](BallSpec& b) { b.position[1] = std::ldexp(1.0, e); }).empty()) << e;
  EXPECT_TRUE(with([&](BallSpec& b) { b.velocity = {0.0, std::ldexp(1.0, -800)}; }).empty());
  for (const int e : {420, -420}) {
    const auto problems = with([&](BallSpec& b) { b.position[1] = std::ldexp(1.0, e); });
    ASSERT_FALSE(problems.empty()) << e;
    EXPECT_THAT(problems[0].what, HasSubstr("out of range"));
    EXPECT_FALSE(with([&](BallSpec& b) { b.mass = std::ldexp(1.0, e); }).empty()) << e;
    EXPECT_FALSE(with([&](BallSpec& b) { b.radius = std::ldexp(1.0, e); }).empty()) << e;
  }
  EXPECT_FALSE(with([&](BallSpec& b) { b.velocity = {0.0, std::ldexp(1.0, -801)}; }).empty());
}

TEST(Refused, a_start_beyond_the_clock) {
  Scene scene = open_space(1);
  scene.balls = {ball({0.0}, {1.0})};
  scene.run.start = 1e300;
  EXPECT_FALSE(problems_of(scene).empty());
  scene.run.start = 0.0;
  scene.run.until = 1e300;
  EXPECT_FALSE(problems_of(scene).empty());
}

// Contacts at the start.

TEST(StartContacts, are_state) {
  Scene scene = box({0.0, 0.0}, {10.0, 10.0});
  scene.balls = {ball({0.5, 0.5}, {}), ball({1.5, 0.5}, {}), ball({5.0, 5.0}, {})};
  const World<double, 2> world = build<double, 2>(scene);
  EXPECT_EQ(world.details[0].contacts.size(), 3u) << "two faces and ball 1";
  EXPECT_EQ(world.details[1].contacts.size(), 2u);
  EXPECT_TRUE(world.details[2].contacts.empty());
  EXPECT_TRUE(world.balls[0].in_contact && world.balls[1].in_contact);
  EXPECT_FALSE(world.balls[2].in_contact);
  for (const Contact<2>& c : world.details[0].contacts) EXPECT_FALSE(c.acted);
}

// Each of the 15 balls of a rack touches all its neighbours, in any direction and position: 30 contacts.
TEST(StartContacts, of_a_rack_are_thirty) {
  for (const double apex : {0.0, 1.0 / 3.0, 1000.1})
    for (const double up : {0.0, 1.0, -0.3})
      for (const double radius : {0.5, 0.028575}) {
        Scene scene = open_space(2);
        LatticeSpec rack;
        rack.kind = LatticeKind::rack;
        rack.radius = radius;
        rack.apex = {apex, -apex};
        rack.direction = {1.0, up};
        scene.lattices = {rack};
        const World<double, 2> world = build<double, 2>(scene);
        std::size_t contacts = 0;
        for (const auto& d : world.details) contacts += d.contacts.size();
        EXPECT_EQ(contacts, 60u) << "apex " << apex << " direction " << up << " radius " << radius;
      }
}

// Units.

// L is a power of two, at most about 2^-12 of the time in which the fastest possible ball crosses the smallest length.
TEST(Units, epochs_are_short_against_a_crossing) {
  Dice dice(3);
  for (int i = 0; i < 200; ++i) {
    const double radius = std::exp(dice.between(-60.0, 60.0)), speed = std::exp(dice.between(-60.0, 60.0));
    const double mass = std::exp(dice.between(-60.0, 60.0));
    Scene scene = open_space(2);
    scene.balls = {ball({0.0, 0.0}, {speed, 0.0}, radius, mass), ball({10.0 * radius, 0.0}, {}, radius, mass)};
    const World<double, 2> world = build<double, 2>(scene);
    int exponent = 0;
    EXPECT_EQ(std::frexp(world.units.epoch_length(), &exponent), 0.5) << "a power of two";
    const double ratio = world.units.epoch_length() / (radius / speed);
    EXPECT_LE(ratio, 0x1p-11);
    EXPECT_GE(ratio, 0x1p-15);
    EXPECT_EQ(std::ldexp(world.balls[0].radius, world.units.length), radius) << "converting never rounds";
    EXPECT_EQ(std::ldexp(world.balls[0].velocity[0], world.units.velocity()), speed);
    EXPECT_EQ(std::ldexp(world.details[0].mass, world.units.mass), mass);
  }
}

TEST(ClockTime, counts_the_text_and_not_its_double) {
  Number third = parse_number("1/3");
  const Time<double> t = clock_time<double>(third, -10);
  EXPECT_EQ(t.epoch, 341);
  EXPECT_EQ(t.offset, 3002399751580331 * 0x1p-53);  // 1024/3 = 341 + 1/3; (2^53 + 1)/3 ticks
  const Time<double> before = clock_time<double>(parse_number("-1/3"), -10);
  EXPECT_EQ(before.epoch, -342);
  EXPECT_EQ(before.offset, 6004799503160661 * 0x1p-53);  // 2/3: (2^54 - 1)/3 ticks
  EXPECT_EQ(clock_time<double>(Number(0x1p-80), 0), (Time<double>{0, 0.0})) << "less than half a tick";
  EXPECT_EQ(clock_time<double>(Number(1.0 - 0x1p-53), 0), (Time<double>{0, 1.0 - 0x1p-53}));
  EXPECT_EQ(clock_time<double>(parse_number("0.99999999999999999999"), 0), (Time<double>{1, 0.0})) << "carried";
  EXPECT_EQ(clock_time<double>(Number(-0x1p-80), 0), (Time<double>{0, 0.0}));
  EXPECT_TRUE(clock_time<double>(Number(1e40), 0).is_never());
}

// Two balls at one number.

TEST(Numbering, balls_then_lattices_and_walls_then_faces) {
  Scene scene = box({-20.0, -20.0}, {20.0, 20.0});
  LatticeSpec rack;
  rack.kind = LatticeKind::rack;
  rack.rows = 2;
  rack.radius = 0.5;
  rack.apex = {0.0, 0.0};
  scene.lattices = {rack};
  scene.balls = {ball({-5.0, 0.0}, {}, 0.25)};
  scene.walls = {circle({0.0, 0.0}, 20.0, WallSide::inside)};
  const Simulation simulation(scene);
  EXPECT_EQ(simulation.balls().size(), 4u);
  EXPECT_EQ(simulation.ball(0).radius, 0.25);
  EXPECT_EQ(simulation.ball(1).position, (std::vector<Number>{0.0, 0.0}));
  EXPECT_EQ(simulation.wall_label(0), "0");
  EXPECT_EQ(simulation.wall_label(1), "x-");
  EXPECT_EQ(simulation.wall_label(4), "y+");
}

}  // namespace
}  // namespace carom
