#include "carom/write/output_file.hpp"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "write/text_file.hpp"

namespace carom {
namespace {

using testing::HasSubstr;

TEST(OutputFile, keeps_every_line_across_writes) {
  const test::Folder folder;
  std::string expected;
  OutputFile file(folder.file("a.txt"));
  for (int k = 0; k < 200000; ++k) {  // 1.3 MB: several writes
    file.line() += std::to_string(k);
    file.end_line();
    expected += std::to_string(k) + '\n';
  }
  file.close();
  EXPECT_EQ(folder.read("a.txt"), expected);
}

TEST(OutputFile, that_nobody_closes_stays_a_part) {
  const test::Folder folder;
  {
    OutputFile file(folder.file("a.txt"));
    file.line() += "one";
    file.end_line();
  }
  EXPECT_EQ(folder.read("a.txt.part"), "one\n");
  EXPECT_THAT(folder.files(), testing::ElementsAre("a.txt.part"));
}

TEST(OutputFile, has_its_name_once_it_is_whole_and_no_older_one_meanwhile) {
  const test::Folder folder;
  folder.write("a.txt", "of a former run");
  OutputFile file(folder.file("a.txt"));
  EXPECT_THAT(folder.files(), testing::ElementsAre("a.txt.part"));
  file.line() += "one";
  file.end_line();
  file.close();
  EXPECT_THAT(folder.files(), testing::ElementsAre("a.txt"));
  EXPECT_EQ(folder.read("a.txt"), "one\n");
  EXPECT_NO_THROW(file.close());
}

TEST(OutputFile, follows_a_link) {
  const test::Folder folder;
  folder.write("target.txt", "old");
  std::filesystem::create_symlink("target.txt", folder.file("link.txt"));
  OutputFile file(folder.file("link.txt"));
  file.line() += "new";
  file.end_line();
  file.close();
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link.txt")));
  EXPECT_EQ(folder.read("target.txt"), "new\n");
}

TEST(OutputFile, names_the_file_and_the_reason) {
  const test::Folder folder;
  const std::string path = folder.file("none/a.txt");
  try {
    OutputFile file(path);
    FAIL() << "opened a file in a folder that is not there";
  } catch (const OutputError& error) {
    EXPECT_THAT(error.what(), testing::AllOf(HasSubstr(path), HasSubstr("No such file or directory")));
  }
}

TEST(OutputFile, finds_a_full_disk_while_writing_and_when_closing) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP();
  OutputFile file("/dev/full");
  file.line() += "one";
  file.end_line();
  EXPECT_FALSE(file.failed()) << "nothing has been written so far";
  file.line().append(std::size_t{1} << 20, 'x');
  file.end_line();
  EXPECT_TRUE(file.failed());
  EXPECT_THROW(file.close(), OutputError);

  OutputFile small("/dev/full");
  small.line() += "one";
  small.end_line();
  EXPECT_THROW(small.close(), OutputError);
}

}  // namespace
}  // namespace carom
