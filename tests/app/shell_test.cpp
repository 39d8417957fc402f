// What shells and man get from the program, and the line of progress.

#include "app/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "progress.hpp"
#include "write/python.hpp"

namespace carom {
namespace {

using test::carom;
using test::Folder;
using testing::HasSubstr;
using testing::Not;

/// What bash offers for the last of these words.
std::string offered(const Folder& folder, const std::string& words) {
  folder.write("ask.sh", "source ./script\nCOMP_WORDS=(" + words + ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_carom\necho \"${COMPREPLY[*]}\"\n");
  return test::printed_by("cd '" + folder.path().string() + "' && bash ask.sh").second;
}

TEST(Completion, in_bash_knows_commands_options_and_values) {
  const Folder folder;
  const test::Outcome o = carom(folder, {"completion", "bash"});
  ASSERT_EQ(o.status, 0);
  folder.write("script", o.out);
  EXPECT_EQ(offered(folder, "carom ru"), "run\n");
  EXPECT_EQ(offered(folder, "carom comp"), "compare completion\n");
  EXPECT_EQ(offered(folder, "carom run --prec"), "--precision\n");
  EXPECT_EQ(offered(folder, "carom run a.toml --j"), "--json\n");
  EXPECT_EQ(offered(folder, "carom run a.toml --until ''"), "\n") << "any time";
  EXPECT_EQ(offered(folder, "carom new break_s"), "break_shot\n");
  EXPECT_EQ(offered(folder, "carom completion z"), "zsh\n");
  EXPECT_EQ(offered(folder, "carom plot d --format p"), "png\n");
  EXPECT_EQ(offered(folder, "carom run sce"), "\n") << "left to the completion of file names";
}

TEST(Completion, in_zsh_and_fish_is_a_script_of_that_shell) {
  const Folder folder;
  for (const std::string shell : {"zsh", "fish"}) {
    const test::Outcome o = carom(folder, {"completion", shell});
    ASSERT_EQ(o.status, 0);
    EXPECT_THAT(o.out, testing::AllOf(HasSubstr("run"), HasSubstr("precision"), HasSubstr("break_shot")));
    folder.write(shell + ".script", o.out);
    if (std::system(("command -v " + shell + " > /dev/null").c_str()) != 0) continue;  // its syntax is checked where it is
    const auto [good, said] = test::printed_by(shell + " -n '" + folder.file(shell + ".script") + "'");
    EXPECT_TRUE(good) << said;
  }
  const test::Outcome wrong = carom(folder, {"completion", "csh"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_THAT(wrong.err, HasSubstr("fish"));
}

TEST(Manual, has_every_command_and_no_line_that_roff_takes_for_a_request) {
  const Folder folder;
  const test::Outcome o = carom(folder, {"man"});
  ASSERT_EQ(o.status, 0);
  for (const char* command : {"run", "check", "compare", "convert", "explain", "new", "plot", "completion", "man"})
    EXPECT_THAT(o.out, HasSubstr(".SS " + std::string(command) + "\n"));
  EXPECT_THAT(o.out, HasSubstr("\\-\\-precision"));
  for (const std::string& line : test::split(o.out, '\n')) {
    if (!line.starts_with('.')) continue;
    EXPECT_THAT(line, testing::ContainsRegex("^\\.(TH|SH|SS|TP|PP|nf|fi)($| )"));
  }
  if (std::system("command -v groff > /dev/null") != 0) return;
  folder.write("carom.1", o.out);
  const auto [good, said] = test::printed_by("groff -man -Tutf8 -ww -z '" + folder.file("carom.1") + "'");
  EXPECT_TRUE(good);
  EXPECT_EQ(said, "");
}

TEST(Progress, line_shows_a_bar_and_the_time_left_and_fits) {
  EXPECT_EQ(app::progress_line("5 events", 0.25, 10.0, 80), "[#####...............]  25 %  30 s left, 5 events");
  EXPECT_EQ(app::progress_line("5 events", 0.0, 10.0, 80), "5 events") << "an end that is not known";
  EXPECT_EQ(app::progress_line("x", 2.0, 10.0, 80), "[####################] 100 %  0 s left, x");
  EXPECT_EQ(app::progress_line("5 events", 0.5, 10.0, 20).size(), 19U);
}

}  // namespace
}  // namespace carom
