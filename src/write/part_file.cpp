#include "part_file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include <fmt/core.h>

namespace carom {

namespace fs = std::filesystem;

PartFile::PartFile(const std::string& name) : name_(name), part_(name + ".part") {
  std::error_code ignored;
  if (fs::is_symlink(name, ignored)) {
    const fs::path target = fs::weakly_canonical(name, ignored);
    if (!ignored) {
      name_ = target.string();
      part_ = name_ + ".part";
    }
  }
  if (fs::exists(name_, ignored) && !fs::is_regular_file(name_, ignored)) part_ = name_;
}

void PartFile::begun() const {
  if (part_ != name_) std::remove(name_.c_str());
}

int PartFile::keep() const {
  errno = 0;
  if (part_ == name_ || std::rename(part_.c_str(), name_.c_str()) == 0) return 0;
  return errno != 0 ? errno : EIO;
}

std::string unwritten(const std::string& name, int error, const std::string& left) {
  const char* remedy = error == ENOSPC || error == EDQUOT || error == EFBIG
                           ? "Free some space, or write elsewhere with --out"
                           : "Make it writable, or write elsewhere with --out";
  const std::string rest = left.empty() || left == name ? "" : fmt::format(" What fitted is in \"{}\".", left);
  return fmt::format("cannot write \"{}\": {}. {}.{}", name, error != 0 ? std::strerror(error) : "unknown error", remedy, rest);
}

}  // namespace carom
