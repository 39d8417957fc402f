// carom run: results, overrides, wrong scenes, stops.

#include "app/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace carom {
namespace {

using Json = nlohmann::ordered_json;
using test::carom;
using test::Folder;
using testing::HasSubstr;

Json json_of(const Folder& folder, std::vector<std::string> words, int status = 0) {
  words.push_back("--json");
  const test::Outcome o = carom(folder, words);
  EXPECT_EQ(o.status, status) << o.err;
  return Json::parse(o.out);  // throws unless it is one JSON text and nothing else
}

TEST(Run, prints_one_json_object) {
  const Folder folder;
  folder.write("a.toml", test::head_on(2));
  const Json j = json_of(folder, {"run", "a.toml"});
  EXPECT_EQ(j["title"], "Head-on");
  EXPECT_EQ(j["events"]["ball_ball"], 1);
  EXPECT_EQ(j["events"]["ball_wall"], 2);
  EXPECT_EQ(j["time"], 6.0);
  EXPECT_EQ(j["energy"]["initial"], 1.0);
  EXPECT_EQ(j["energy"]["relative_error"], 0.0);
  EXPECT_GE(j["seconds"].get<double>(), 0.0);
  EXPECT_GT(j["peak_memory_mb"].get<double>(), 0.5);
  EXPECT_LT(j["peak_memory_mb"].get<double>(), 1000.0);
  EXPECT_FALSE(j.contains("final"));
  EXPECT_FALSE(j.contains("stopped"));
}

TEST(Run, gives_the_final_state_when_asked) {
  const Folder folder;
  folder.write("a.toml", test::head_on(2));
  const Json final = json_of(folder, {"run", "a.toml", "--final"})["final"];
  ASSERT_EQ(final.size(), 2U);
  EXPECT_EQ(final[1], Json::parse(R"({"index": 1, "name": "", "position": [8.5, 5.0], "image": [0, 0],
                                      "unwrapped_position": [8.5, 5.0], "velocity": [-1.0, 0.0]})"));
}

TEST(Run, prints_a_table_for_people) {
  const Folder folder;
  folder.write("a.toml", test::head_on(2));
  const test::Outcome o = carom(folder, {"run", "a.toml"});
  EXPECT_EQ(o.status, 0);
  EXPECT_EQ(o.err, "");
  EXPECT_THAT(o.out,
              testing::AllOf(HasSubstr("Head-on"), HasSubstr("left"), HasSubstr("0 ulp"), testing::Not(HasSubstr("\x1b"))));
  EXPECT_EQ(carom(folder, {"run", "a.toml", "--quiet"}).out, "");
}

TEST(Run, takes_overrides) {
  const Folder folder;
  folder.write("a.toml", test::head_on(2));
  EXPECT_EQ(json_of(folder, {"run", "a.toml", "--until", "5"})["events"]["ball_wall"], 2)
      << "events at the end are included";
  EXPECT_EQ(json_of(folder, {"run", "a.toml", "--until", "14/3"})["time"], 14.0 / 3.0);
  const Json two = json_of(folder, {"run", "a.toml", "--events", "2"});
  EXPECT_EQ(two["stopped_by"], "events");
  EXPECT_EQ(two["events"]["ball_wall"], 1) << "also between two simultaneous ones";
  EXPECT_EQ(two["time"], 5.0);
  EXPECT_EQ(
      json_of(folder, {"run", "a.toml", "--set", "ball.0.velocity=[0,0]", "--set", "ball.0.mass=3"})["energy"]["initial"],
      0.5);
  EXPECT_EQ(json_of(folder, {"run", "--set", "collision.restitution=0", "a.toml"})["energy"]["dissipated"], 1.0);
}

TEST(Run, refuses_a_missing_scene_and_a_wrong_one) {
  const Folder folder;
  const test::Outcome missing = carom(folder, {"run", "none.toml", "--json"});
  EXPECT_EQ(missing.status, 2);
  EXPECT_EQ(missing.out, "");
  EXPECT_THAT(missing.err, HasSubstr("none.toml"));

  folder.write("wrong.toml", test::head_on(2) + "speed = 3\n[collision]\nrestitution = 2\n");
  const test::Outcome wrong = carom(folder, {"run", "wrong.toml", "--json"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_EQ(wrong.out, "");
  EXPECT_THAT(wrong.err, testing::AllOf(HasSubstr("speed"), HasSubstr("restitution"))) << "every problem";
  EXPECT_THAT(wrong.err, testing::StartsWith("wrong.toml:"));
}

TEST(Run, names_the_option_that_is_wrong) {
  const Folder folder;
  folder.write("a.toml", test::head_on(2));
  EXPECT_THAT(carom(folder, {"run", "a.toml", "--until", "-3"}).err, testing::StartsWith("carom: --until -3: "));
  EXPECT_THAT(carom(folder, {"run", "a.toml", "--set", "ball.0.mass=0"}).err, HasSubstr("--set ball.0.mass=0: "));
}

// Two balls of infinite mass meet: no law says what follows.
TEST(Run, stops_where_going_on_is_meaningless) {
  const Folder folder;
  folder.write("a.toml", test::head_on(2, "[output]\nevents = \"events.csv\"\n"));
  const std::vector<std::string> words{"run", "a.toml", "--set", "ball.0.mass=inf", "--set", "ball.1.mass=inf"};
  const test::Outcome o = carom(folder, words);
  EXPECT_EQ(o.status, 3);
  EXPECT_THAT(o.err, testing::AllOf(HasSubstr("time 1"), HasSubstr("balls 0, 1"), HasSubstr("finite mass")));
  EXPECT_EQ(test::Csv(folder.read("events.csv")).comments.back(), "# end: collapse, 0 events");
  const Json j = json_of(folder, words, 3);
  EXPECT_EQ(j["stopped_by"], "collapse");
  EXPECT_EQ(j["stopped"]["balls"], Json({0, 1}));
  EXPECT_EQ(j["stopped"]["time"], 1.0);
}

}  // namespace
}  // namespace carom
