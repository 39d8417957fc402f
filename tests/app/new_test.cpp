// carom new: the gallery.

#include "app/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gallery.hpp"

namespace carom {
namespace {

using app::gallery;
using app::GalleryScene;
using test::carom;
using test::Folder;
using testing::HasSubstr;

std::string source_of(const GalleryScene& scene) {
  std::ifstream in(CAROM_SOURCE_DIR "/examples/" + std::string(scene.name) + "/scene.toml", std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

TEST(New, holds_every_example_byte_for_byte) {
  std::size_t examples = 0;
  for (const auto& entry : std::filesystem::directory_iterator(CAROM_SOURCE_DIR "/examples"))
    examples += std::filesystem::exists(entry.path() / "scene.toml");
  EXPECT_EQ(gallery().size(), examples);
  for (const GalleryScene& scene : gallery()) EXPECT_EQ(scene.text, source_of(scene)) << scene.name;
}

TEST(New, lists_names_with_their_first_comment) {
  const Folder folder;
  const test::Outcome o = carom(folder, {"new", "--list"});
  EXPECT_EQ(o.status, 0);
  for (const GalleryScene& scene : gallery()) EXPECT_THAT(o.out, HasSubstr(std::string(scene.name) + " "));
  const std::vector<std::string> lines = test::split(o.out, '\n');
  EXPECT_EQ(lines.size(), gallery().size() + 1);
  for (std::size_t k = 0; k < gallery().size(); ++k)
    EXPECT_GT(lines[k].size(), gallery()[k].name.size() + 10) << "no subject: " << lines[k];
}

TEST(New, writes_a_scene_that_runs) {
  ASSERT_FALSE(gallery().empty());
  const GalleryScene& first = gallery().front();
  const Folder folder;
  EXPECT_EQ(carom(folder, {"new", std::string(first.name)}).status, 0);
  EXPECT_EQ(folder.read(std::string(first.name) + ".toml"), first.text);
  EXPECT_EQ(carom(folder, {"new", std::string(first.name), "--out", "mine.toml"}).status, 0);
  EXPECT_EQ(folder.read("mine.toml"), first.text);
  EXPECT_EQ(carom(folder, {"run", "mine.toml", "--events", "1"}).status, 0);
}

TEST(New, has_the_scene_that_the_help_names) {
  const Folder folder;
  EXPECT_THAT(carom(folder, {"--help"}).out, HasSubstr("carom new break_shot"));
  EXPECT_EQ(carom(folder, {"new", "break_shot"}).status, 0);
}

TEST(New, overwrites_nothing) {
  const Folder folder;
  const std::string name(gallery().front().name);
  folder.write(name + ".toml", "mine");
  const test::Outcome o = carom(folder, {"new", name});
  EXPECT_EQ(o.status, 2);
  EXPECT_THAT(o.err, HasSubstr(name + ".toml"));
  EXPECT_EQ(folder.read(name + ".toml"), "mine");
}

TEST(New, suggests_a_name_for_an_unknown_one) {
  const Folder folder;
  const std::string name(gallery().front().name);
  const test::Outcome o = carom(folder, {"new", name + "x"});
  EXPECT_EQ(o.status, 2);
  EXPECT_THAT(o.err, HasSubstr("Did you mean \"" + name + "\"?"));
  const test::Outcome far = carom(folder, {"new", "qqqqqqqq"});
  EXPECT_EQ(far.status, 2);
  EXPECT_EQ(far.err, "carom: there is no scene \"qqqqqqqq\" in the gallery. All of them: carom new --list\n");
  EXPECT_EQ(carom(folder, {"new"}).status, 2);
  EXPECT_EQ(carom(folder, {"new", name, "--out", "none/a.toml"}).status, 3);
}

}  // namespace
}  // namespace carom
