#include "carom/write/output_file.hpp"

#include <cerrno>
#include <cstring>
#include <utility>

#include <fmt/core.h>

namespace carom {

namespace {

constexpr std::size_t big_write = std::size_t{1} << 18;

std::string message(const std::string& path, int error) {
  const char* remedy = error == ENOSPC || error == EDQUOT || error == EFBIG
                           ? "Free some space, or write elsewhere with --out"
                           : "Make it writable, or write elsewhere with --out";
  return fmt::format("cannot write \"{}\": {}. {}.", path, error != 0 ? std::strerror(error) : "unknown error", remedy);
}

}  // namespace

OutputFile::OutputFile(std::string path) : path_(std::move(path)) {
  errno = 0;
  file_ = std::fopen(path_.c_str(), "wb");
  if (file_ == nullptr) throw OutputError(message(path_, errno));
  std::setvbuf(file_, nullptr, _IONBF, 0);  // the buffer is here
  buffer_.reserve(big_write + 4096);
}

OutputFile::~OutputFile() {
  if (file_ == nullptr) return;
  flush();
  std::fclose(file_);
}

void OutputFile::end_line() {
  buffer_ += '\n';
  if (buffer_.size() >= big_write) flush();
}

void OutputFile::flush() {
  // What a failed write may have left half on the disk is not followed by anything.
  errno = 0;
  if (!failed() && std::fwrite(buffer_.data(), 1, buffer_.size(), file_) != buffer_.size())
    error_ = errno != 0 ? errno : EIO;
  buffer_.clear();
}

void OutputFile::close() {
  if (file_ != nullptr) {
    flush();
    errno = 0;
    if (std::fclose(std::exchange(file_, nullptr)) != 0 && !failed()) error_ = errno != 0 ? errno : EIO;
  }
  if (failed()) throw OutputError(message(path_, error_));
}

}  // namespace carom
