#include "carom/write/checkpoint_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <span>
#include <string_view>
#include <utility>

#include "carom/core/error.hpp"
#include "carom/write/output_file.hpp"

namespace carom {

namespace {

[[noreturn]] void fail(const std::string& path, int error) {
  throw OutputError("cannot write the checkpoint \"" + path + "\": " + std::strerror(error) +
                    ". Free some space, or write elsewhere with --out.");
}

/// A file that is written and brought to the disk. After the first error nothing more is written.
class Store {
 public:
  explicit Store(const std::string& path) : file_(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
    if (file_ < 0) error_ = errno;
  }
  ~Store() {
    if (file_ >= 0) ::close(file_);
  }
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  void write(std::string_view bytes) {
    while (!bytes.empty() && error_ == 0) {
      const ssize_t n = ::write(file_, bytes.data(), bytes.size());
      if (n > 0) bytes.remove_prefix(static_cast<std::size_t>(n));
      if (n < 0 && errno != EINTR) error_ = errno;
    }
  }
  /// The first error, or 0.
  [[nodiscard]] int finish() {
    if (error_ == 0 && ::fsync(file_) != 0 && errno != EINVAL) error_ = errno;
    if (file_ >= 0 && ::close(std::exchange(file_, -1)) != 0 && error_ == 0) error_ = errno;
    return error_;
  }

 private:
  int file_;
  int error_ = 0;
};

/// The state in `path`; the error, or 0.
int store(const std::string& path, const Simulation& simulation) {
  Store file(path);
  simulation.save([&file](std::string_view piece) { file.write(piece); });
  return file.finish();
}

}  // namespace

void write_checkpoint(const std::string& path, const Simulation& simulation) {
  const std::string aside = path + ".part";
  if (const int error = store(aside, simulation); error != 0) {
    ::unlink(aside.c_str());
    fail(path, error);
  }
  if (std::rename(aside.c_str(), path.c_str()) != 0) {
    const int error = errno;
    ::unlink(aside.c_str());
    fail(path, error);
  }
}

void read_checkpoint(const std::string& path, Simulation& simulation) {
  const auto refuse = [&path](const char* why) {
    throw InputError(Problem{path, 0, "cannot read the checkpoint", why, "Check the name after --resume"});
  };
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse(std::strerror(errno));
  file.seekg(0, std::ios::end);
  const std::streamoff size = file.tellg();
  if (!file || size < 0) refuse("it is no file of a known length");
  try {
    simulation.restore(static_cast<std::uint64_t>(size), [&](std::uint64_t at, std::span<char> to) {
      file.seekg(static_cast<std::streamoff>(at));
      if (!file.read(to.data(), static_cast<std::streamsize>(to.size()))) refuse("it has changed while it was read, or the disk fails");
    });
  } catch (const InputError& error) {
    std::vector<Problem> problems = error.problems();
    for (Problem& p : problems) p.file = path;
    throw InputError(std::move(problems));
  }
}

}  // namespace carom
