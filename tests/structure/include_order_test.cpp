// The includes go one way: a file may include its own stage and the stages before it.

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;

/// The stages in order; stages on one step do not know each other. "carom" is the umbrella carom/carom.hpp, for the program
/// alone.
const std::map<std::string, int> step{{"core", 0},   {"solve", 1},   {"scene", 2},       {"motion", 3},  {"shape", 3},
                                      {"law", 3},    {"world", 4},   {"predict", 5},     {"queue", 6},   {"search", 6},
                                      {"sim", 7},    {"prepare", 8}, {"game_engine", 8}, {"observe", 9}, {"certify", 10},
                                      {"write", 11}, {"carom", 11}, {"view", 12},        {"app", 13}};

bool may_include(const std::string& stage, const std::string& included) {
  return stage == included || (step.contains(included) && step.at(included) < step.at(stage));
}

/// The lines of `source` that include a stage which a file of `stage` must not know.
std::vector<std::string> back_edges(const std::string& stage, std::istream& source) {
  // <carom/STAGE/...>, "carom/STAGE/..." or, within src, "STAGE/...". A quoted name without a folder is of the same stage.
  static const std::regex own_include(R"re(^\s*#\s*include\s*(?:[<"]carom/|"|<(?=carom/))([^/">]+)/[^">]*[">].*)re");
  std::vector<std::string> found;
  std::smatch match;
  for (std::string line; std::getline(source, line);) {
    if (std::regex_match(line, match, own_include) && !may_include(stage, match[1])) found.push_back(line);
  }
  return found;
}

std::vector<std::string> back_edges(const std::string& stage, const std::string& text) {
  std::istringstream source(text);
  return back_edges(stage, source);
}

TEST(IncludeOrder, allows_the_own_stage_and_those_before) {
  EXPECT_TRUE(
      back_edges("sim", "#include <vector>\n#include \"carom/sim/run.hpp\"\n#include <carom/queue/heap.hpp>\n").empty());
  EXPECT_TRUE(back_edges("app", "#include \"commands.hpp\"\n#include \"app/commands.hpp\"\n").empty());
}

TEST(IncludeOrder, finds_back_edges) {
  EXPECT_EQ(back_edges("core", "#include \"carom/solve/quadratic.hpp\"").size(), 1U);
  EXPECT_EQ(back_edges("world", "  # include <carom/sim/run.hpp>  // why not").size(), 1U);
  EXPECT_EQ(back_edges("motion", "#include \"carom/shape/plane.hpp\"").size(), 1U);
  EXPECT_EQ(back_edges("queue", "#include \"carom/search/cell_grid.hpp\"").size(), 1U);
  EXPECT_EQ(back_edges("sim", "#include \"../write/csv.hpp\"").size(), 1U);
  EXPECT_EQ(back_edges("sim", "#include <carom/carom.hpp>").size(), 1U);
  EXPECT_EQ(back_edges("sim", "#include \"carom/utils/all.hpp\"").size(), 1U);
}

TEST(IncludeOrder, holds_in_every_file) {
  int files = 0;
  for (const fs::path root : {CAROM_SOURCE_DIR "/include/carom", CAROM_SOURCE_DIR "/src"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
      const fs::path name = entry.path().lexically_relative(root);
      const std::string extension = name.extension();
      if (extension != ".hpp" && extension != ".cpp") continue;
      if (!name.has_parent_path()) continue;  // the umbrella carom.hpp
      const std::string stage = *name.begin();
      ASSERT_TRUE(step.contains(stage)) << entry.path() << " is in no stage";
      std::ifstream source(entry.path());
      for (const std::string& line : back_edges(stage, source)) ADD_FAILURE() << entry.path() << ": " << line;
      ++files;
    }
  }
  EXPECT_GT(files, 5);
}

}  // namespace
