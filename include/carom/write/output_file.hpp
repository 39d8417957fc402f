#pragma once
// A text file written line by line, in big writes, that remembers what went wrong.

#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>

namespace carom {

/// Output could not be written (exit status 3): the file, the reason and a remedy.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class PartFile;

/// While it is written it is PATH.part, and an older PATH is gone: a file that has its name is whole. What is no regular file
/// (/dev/stdout, a pipe) is written to directly.
class OutputFile {
 public:
  /// Begins the file. Throws OutputError.
  explicit OutputFile(std::string path);
  /// Without `close` the file stays PATH.part, with the complete lines that were left.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Where the next line is to be composed. `end_line` ends it.
  [[nodiscard]] std::string& line() noexcept { return buffer_; }
  void end_line();

  /// Hands on what is complete, for who reads while it is written.
  void flush();

  /// Whether a write has failed. What comes after is dropped.
  [[nodiscard]] bool failed() const noexcept { return error_ != 0; }

  /// Writes out everything, closes the file and gives it its name. Throws OutputError if any write has failed.
  void close();

  [[nodiscard]] const std::string& path() const noexcept { return path_; }

 private:
  std::string path_;
  std::unique_ptr<const PartFile> part_;
  std::string buffer_;
  std::FILE* file_ = nullptr;
  int error_ = 0;  // errno of the first failure
};

}  // namespace carom
