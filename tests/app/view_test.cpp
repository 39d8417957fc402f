// carom view: what is in the page, from what it is made, and what is refused. The page itself is tested in tests/view.

#include "app/program.hpp"

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "page_parts.hpp"

namespace carom {
namespace {

using nlohmann::json;
using test::carom;
using test::Folder;
using testing::AllOf;
using testing::HasSubstr;

const char* const head_on =
    "title = \"Head </script> on\"\n[[ball]]\nposition = [-2, 0]\nvelocity = [1, 0]\n[[ball]]\nname = \"target\"\nposition "
    "= [2, 0]\n"
    "[output]\nevents = \"events.csv\"\n[run]\nuntil = 10\n";

/// The page, and the JSON of its element `id`.
json element(const std::string& page, const std::string& id) {
  const std::string begin = "id=\"" + id + "\">";
  const std::size_t from = page.find(begin);
  if (from == std::string::npos) return nullptr;
  return json::parse(page.substr(from + begin.size(), page.find("</script>", from) - from - begin.size()));
}

class ViewCommand : public testing::Test {
 protected:
  void SetUp() override {
    if (app::page_parts() == nullptr) GTEST_SKIP() << "built without node";
  }
};

TEST_F(ViewCommand, writes_one_page_with_scene_log_and_result) {
  const Folder folder;
  folder.write("a.toml", head_on);
  const test::Outcome o = carom(folder, {"view", "a.toml", "--set", "ball.0.velocity=[2,0]"});
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_THAT(o.out, AllOf(HasSubstr("Wrote a.html ("), HasSubstr("1 events")));
  const std::string page = folder.read("a.html");
  const json scene = element(page, "scene"), result = element(page, "result");
  EXPECT_EQ(scene["title"], "Head </script> on") << "a title ends no script";
  EXPECT_EQ(scene["names"]["1"], "target");
  EXPECT_EQ(scene["energy"], 2.0);
  EXPECT_THAT(scene["text"].get<std::string>(), AllOf(HasSubstr("# --set ball.0.velocity=[2,0]"), HasSubstr("until = 10")));
  EXPECT_EQ(result["summary"]["events"]["ball_ball"], 1);
  EXPECT_TRUE(result["cut"].is_null());
  EXPECT_THAT(page, HasSubstr("class=\"chunk\""));
  EXPECT_EQ(page.find("http://"), page.find("http://www.w3.org")) << "nothing is fetched";
}

TEST_F(ViewCommand, makes_a_run_again_from_its_folder) {
  const Folder folder;
  folder.write("a.toml", head_on);
  ASSERT_EQ(
      carom(folder, {"run", "a.toml", "--out", "results", "--set", "ball.0.velocity=[4,0]", "--until", "3", "--quiet"})
          .status,
      0);
  folder.write("a.toml", "");  // the record has the scene of the run
  folder.write("results/curve.csv", "# measured\nx,y\n1,2\n2,nan\n3,5\n");
  const test::Outcome o = carom(folder, {"view", "results", "--out", "b.html"});
  EXPECT_EQ(o.status, 0) << o.err;
  const json result = element(folder.read("b.html"), "result");
  EXPECT_EQ(result["summary"]["energy"]["initial"], 8.0);
  EXPECT_EQ(result["summary"]["time"], 3.0);
  ASSERT_EQ(result["tables"].size(), 1u) << "an event log is no table";
  EXPECT_EQ(result["tables"][0]["name"], "curve");
  EXPECT_EQ(result["tables"][0]["columns"][1]["values"], json({2.0, nullptr, 5.0}));
}

TEST_F(ViewCommand, says_where_it_cuts_a_long_run) {
  const Folder folder;
  folder.write("a.toml",
               "dimension = 1\n[space]\nkind = \"box\"\nlower = [0]\nupper = [10]\n[[ball]]\nposition = [5]\nvelocity = "
               "[1]\n[run]\nuntil = 1000\n");
  const test::Outcome o = carom(folder, {"view", "a.toml", "--most", "20"});
  EXPECT_EQ(o.status, 0);
  EXPECT_THAT(o.err, HasSubstr("the page holds the first 20 collisions"));
  EXPECT_EQ(element(folder.read("a.html"), "result")["cut"], 20);
}

TEST_F(ViewCommand, shows_a_run_that_stops_up_to_there) {
  const Folder folder;
  folder.write("a.toml",
               "[motion]\nacceleration = [0, -9.81]\n[collision]\nrestitution = 0.5\n[[wall]]\nkind = \"plane\"\npoint = "
               "[0, 0]\nnormal = [0, 1]\n"
               "[[ball]]\nposition = [0, 2]\n[run]\nuntil = 10\n");
  const test::Outcome o = carom(folder, {"view", "a.toml", "--picture", "a.svg"});
  EXPECT_EQ(o.status, 3);
  EXPECT_THAT(o.err, HasSubstr("The page shows it up to there."));
  EXPECT_TRUE(element(folder.read("a.html"), "result")["summary"].contains("stopped"));
  EXPECT_THAT(folder.read("a.svg"), AllOf(HasSubstr("<svg"), HasSubstr("class=\"ball\""), HasSubstr("class=\"path\"")));
}

// A gap of 3 closes at 1: collision 0 at t = 3, which steps of 4 do not see (each step moves ball 0 by its diameters' sum
// twice over).
TEST_F(ViewCommand, names_the_collisions_that_steps_miss) {
  const Folder folder;
  folder.write("a.toml", head_on);
  ASSERT_EQ(carom(folder, {"view", "a.toml", "--compare", "5", "--until", "40"}).status, 0);
  json head = element(folder.read("a.html"), "steps-head");
  EXPECT_EQ(head["missed"], json({0}));
  EXPECT_EQ(head["frames"], 9) << "the start and eight steps";
  ASSERT_EQ(carom(folder, {"view", "a.toml", "--compare", "0.1,swept"}).status, 0);
  head = element(folder.read("a.html"), "steps-head");
  EXPECT_EQ(head["missed"], json::array());
  EXPECT_THAT(head["method"].get<std::string>(), HasSubstr("swept"));
}

TEST_F(ViewCommand, refuses_what_it_cannot_show) {
  const Folder folder;
  folder.write("a.toml", head_on);
  std::filesystem::create_directory(folder.file("empty"));
  EXPECT_THAT(carom(folder, {"view", "empty"}).err, HasSubstr("neither a run.json nor a scene.toml"));
  EXPECT_THAT(carom(folder, {"view", "a.toml", "--out", "a.toml"}).err, HasSubstr("is the scene file itself"));
  EXPECT_THAT(carom(folder, {"view", "a.toml", "--compare", "0.1,nosuch"}).err, HasSubstr("nosuch"));
  EXPECT_THAT(carom(folder, {"view", "a.toml", "--compare", "0.1", "--set", "collision.law=\"merge\""}).err,
              HasSubstr("needs the law"));
  EXPECT_EQ(carom(folder, {"view", "a.toml", "--compare", "1e9"}).status, 2);
  EXPECT_FALSE(std::filesystem::exists(folder.file("a.html")));
}

}  // namespace
}  // namespace carom
