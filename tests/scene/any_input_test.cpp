// No text can break the reader: it gives a scene or problems that can be printed.

#include <algorithm>
#include <random>
#include <sstream>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "carom/scene/read.hpp"
#include "carom/scene/validate.hpp"
#include "full_scene.hpp"

namespace carom {
namespace {

using testing::full_scene;

// Reads; a text that is refused has a reason, and every line named is one of the text or the one after it.
void survive(const std::string& text, const std::vector<Override>& overrides = {}) {
  const scene_text::Reading r = testing::reading(text, overrides);
  const auto lines = std::count(text.begin(), text.end(), '\n') + 1;
  for (const Problem& p : r.problems) {
    ASSERT_FALSE(p.text().empty());
    ASSERT_GE(p.line, 0) << p.text();
    ASSERT_LE(p.line, lines) << p.text();
  }
  if (r.problems.empty()) {
    ASSERT_TRUE(validate(r.scene).empty()) << text;
  }
}

TEST(AnyInput, cut_off_at_every_byte) {
  for (std::size_t n = 0; n <= full_scene.size(); ++n) survive(full_scene.substr(0, n));
}

TEST(AnyInput, with_bytes_changed) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 2000; ++i) {
    std::string text = full_scene;
    for (std::uint64_t k = 1 + random() % 3; k > 0; --k) text[random() % text.size()] = static_cast<char>(random());
    survive(text);
  }
}

TEST(AnyInput, with_values_and_lines_exchanged) {
  // Syntax mostly stays right, so that types, ranges and combinations are met.
  const std::vector<std::string> values = {"0",          "-1",       "nan",        "-inf",
                                           "\"1/0\"",    "\"\"",     "[]",         "[[]]",
                                           "{}",         "[{}]",     "true",       "1e308",
                                           "\"inf\"",    "[1, [2]]", "[1,2,3]",    "[\"\"]",
                                           "2020-01-01", "0b1",      "1e-300",     "9223372036854775807",
                                           "'x'",        "{a=1}",    "[nan, inf]", "-9223372036854775808"};
  std::vector<std::string> lines;
  std::istringstream in(full_scene);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  std::mt19937_64 random(2);
  for (int i = 0; i < 2000; ++i) {
    std::vector<std::string> changed = lines;
    for (std::uint64_t k = 1 + random() % 4; k > 0; --k) {
      std::string& line = changed[random() % changed.size()];
      if (const std::size_t at = line.find(" = "); at != std::string::npos && random() % 4 > 0) {
        line = line.substr(0, at + 3) + values[random() % values.size()];
      } else {
        std::swap(line, changed[random() % changed.size()]);
      }
    }
    std::string text;
    for (const std::string& line : changed) text += line + "\n";
    survive(text);
  }
}

TEST(AnyInput, with_any_override) {
  const std::vector<std::string> keys = {"ball",
                                         "ball.0",
                                         "ball.0.position",
                                         "ball.0.position.1",
                                         "space",
                                         "run",
                                         "wall.3",
                                         "wall.3.vertices.1",
                                         "material",
                                         "material.ivory",
                                         "observe.after",
                                         "lattice",
                                         "gas.0.count",
                                         "output",
                                         "material_pair.0.of"};
  const std::vector<std::string> values = {"1",
                                           "nan",
                                           "[]",
                                           "{}",
                                           "[1, 2]",
                                           "[{}]",
                                           "x",
                                           "",
                                           "\"",
                                           "\n",
                                           "\x80",
                                           "[[1, 2], 3]",
                                           "{ kind = \"rack\" }",
                                           "1 # c",
                                           "{",
                                           "'''",
                                           "\xEF\xBB\xBF",
                                           "= 3"};
  for (const std::string& key : keys) {
    for (const std::string& value : values) survive(full_scene, {{key, value}, {key + ".x", value}});
  }
}

TEST(AnyInput, nested_beyond_reason) {
  const std::string many(100000, '[');
  std::string dotted = "a", quoted_dots = "'='";
  for (int i = 0; i < 200000; ++i) dotted += ".a";
  for (int i = 0; i < 200000; ++i) quoted_dots += ".'='";
  std::string steps;  // each table a little deeper than the one before
  for (int i = 0; i < 200; ++i) steps += "x = [{a.b.c.d.e.f.g.h = ";
  for (const std::string& text :
       {"x = " + many, dotted + " = 1", "[" + dotted + "]", "[" + dotted, "[[" + dotted + "]]", quoted_dots + " = 1",
        "t = [{ s = \"\"\"\n\"\"\", " + dotted + " = 1 }]", "t = [{ s = '''\n''', " + quoted_dots + " = 1 }]", steps,
        std::string(100000, '{'), "x = " + std::string(100000, '-'), std::string(1000, '\0')}) {
    survive(text);
  }
}

TEST(AnyInput, long_lines_are_read_in_linear_time) {
  // 20000 points on one line, after a letter of two bytes.
  std::string text = "wall = [{ kind = \"polygon\", material = \"\xC3\xA9\", vertices = [";
  for (int i = 0; i < 20000; ++i) text += fmt::format("[{}.5, {}], ", i, i % 7);
  text += "]}]\n";
  const scene_text::Reading r = testing::reading(text);
  ASSERT_EQ(r.scene.walls.at(0).vertices.size(), 20000u);
  EXPECT_EQ(r.scene.walls[0].vertices[19999][0].text, "19999.5");
}

}  // namespace
}  // namespace carom
