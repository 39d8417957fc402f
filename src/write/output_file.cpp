#include "carom/write/output_file.hpp"

#include <cerrno>
#include <utility>

#include "part_file.hpp"

namespace carom {

namespace {

constexpr std::size_t big_write = std::size_t{1} << 18;

}  // namespace

OutputFile::OutputFile(std::string path) : path_(std::move(path)), part_(std::make_unique<PartFile>(path_)) {
  errno = 0;
  file_ = std::fopen(part_->path().c_str(), "wb");
  if (file_ == nullptr) throw OutputError(unwritten(path_, errno));
  part_->begun();
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
    if (!failed()) error_ = part_->keep();
  }
  if (failed()) throw OutputError(unwritten(path_, error_, part_->path()));
}

}  // namespace carom
