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

TEST(OutputFile, writes_what_it_has_when_nobody_closes_it) {
  const test::Folder folder;
  {
    OutputFile file(folder.file("a.txt"));
    file.line() += "one";
    file.end_line();
  }
  EXPECT_EQ(folder.read("a.txt"), "one\n");
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
