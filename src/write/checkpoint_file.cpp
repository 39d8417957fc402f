#include "carom/write/checkpoint_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>

#include "carom/core/error.hpp"
#include "carom/write/output_file.hpp"

namespace carom {

namespace {

[[noreturn]] void fail(const std::string& path, int error) {
  throw OutputError("cannot write the checkpoint \"" + path + "\": " + std::strerror(error) +
                    ". Free some space, or write elsewhere with --out.");
}

/// Writes all bytes and brings them to the disk; the error, or 0.
int store(const std::string& path, const std::string& bytes) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) return errno;
  std::size_t done = 0;
  int error = 0;
  while (done < bytes.size() && error == 0) {
    const ssize_t n = ::write(file, bytes.data() + done, bytes.size() - done);
    if (n > 0) done += static_cast<std::size_t>(n);
    if (n < 0 && errno != EINTR) error = errno;
  }
  if (error == 0 && ::fsync(file) != 0 && errno != EINVAL) error = errno;
  if (::close(file) != 0 && error == 0) error = errno;
  return error;
}

}  // namespace

void write_checkpoint(const std::string& path, const Simulation& simulation) {
  const std::string aside = path + ".part";
  if (const int error = store(aside, simulation.state()); error != 0) {
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
  std::ifstream file(path, std::ios::binary);
  if (!file)
    throw InputError(Problem{path, 0, "cannot read the checkpoint", std::strerror(errno), "Check the name after --resume"});
  const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  try {
    simulation.restore(bytes);
  } catch (const InputError& error) {
    std::vector<Problem> problems = error.problems();
    for (Problem& p : problems) p.file = path;
    throw InputError(std::move(problems));
  }
}

}  // namespace carom
