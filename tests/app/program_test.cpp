// The program as a shell sees it: help, version, exit statuses.

#include "app/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace carom {
namespace {

using test::carom;
using test::Folder;
using testing::HasSubstr;

TEST(Program, alone_prints_help) {
  const Folder folder;
  const test::Outcome o = carom(folder, {});
  EXPECT_EQ(o.status, 0);
  EXPECT_THAT(o.out, testing::AllOf(HasSubstr("run"), HasSubstr("explain"), HasSubstr("new")));
  EXPECT_EQ(o.err, "");
}

TEST(Program, says_its_version) {
  const Folder folder;
  const test::Outcome o = carom(folder, {"--version"});
  EXPECT_EQ(o.status, 0);
  EXPECT_THAT(o.out, testing::MatchesRegex("carom [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST(Program, every_command_has_help_with_an_example) {
  const Folder folder;
  for (const std::string command : {"run", "explain", "new"}) {
    const test::Outcome o = carom(folder, {command, "--help"});
    EXPECT_EQ(o.status, 0);
    EXPECT_THAT(o.out, HasSubstr("Example:\n  carom " + command));
  }
}

TEST(Program, refuses_wrong_command_lines_with_status_2) {
  const Folder folder;
  folder.write("a.toml", test::head_on(2));
  const std::vector<std::vector<std::string>> wrong{{"rnu", "a.toml"},
                                                    {"--bogus"},
                                                    {"run"},
                                                    {"run", "a.toml", "b"},
                                                    {"run", "--bogus"},
                                                    {"run", "a.toml", "--events"},
                                                    {"run", "a.toml", "--set", "nothing"},
                                                    {"run", "a.toml", "--events", "many"},
                                                    {"run", "a.toml", "--until", "soon"}};
  for (const auto& words : wrong) {
    const test::Outcome o = carom(folder, words);
    EXPECT_EQ(o.status, 2) << testing::PrintToString(words);
    EXPECT_EQ(o.out, "") << testing::PrintToString(words);
    EXPECT_NE(o.err, "") << testing::PrintToString(words);
  }
  EXPECT_THAT(carom(folder, {"rnu"}).err, HasSubstr("Did you mean \"run\"?"));
}

// Head-on at e = 1, equal masses: whole numbers, in any arithmetic. With digits they are strings.
TEST(Program, runs_in_the_precision_asked_for) {
  const Folder folder;
  folder.write("a.toml", test::head_on(2));
  for (const char* precision : {"double", "long-double", "50"}) {
    const test::Outcome o = carom(folder, {"run", "a.toml", "--precision", precision, "--json", "--final"});
    EXPECT_EQ(o.status, 0) << o.err;
    EXPECT_THAT(o.out, HasSubstr("\"precision\": \"" + std::string(precision) + "\""));
    EXPECT_EQ(o.out.find("\"velocity\": [\"") != std::string::npos, std::string(precision) != "double");
  }
  for (const char* wrong : {"quad", "10", "50.5"}) EXPECT_EQ(carom(folder, {"run", "a.toml", "--precision", wrong}).status, 2);
}

TEST(Program, tells_when_its_result_cannot_be_written) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP();
  const Folder folder;
  folder.write("a.toml", test::head_on(2));
  for (const auto& words : std::vector<std::vector<std::string>>{
           {"run", "a.toml", "--json"}, {"run", "a.toml"}, {"explain", "a.toml"}, {"--help"}}) {
    const test::Outcome o = carom(folder, words, "/dev/full");
    EXPECT_EQ(o.status, 3);
    EXPECT_THAT(o.err, HasSubstr("standard output"));
  }
}

}  // namespace
}  // namespace carom
