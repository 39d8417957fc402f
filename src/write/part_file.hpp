#pragma once
// A file gets its name when it is whole. Until then it is NAME.part.

#include <string>

namespace carom {

class PartFile {
 public:
  /// What is no regular file (a device, a pipe) is written to directly. A link keeps pointing to its file.
  explicit PartFile(const std::string& name);

  /// Where to write.
  [[nodiscard]] const std::string& path() const noexcept { return part_; }

  /// Takes away what a former run has left under the name, once a new file is begun: it is not to be taken for the new one.
  void begun() const;

  /// The file is whole. Returns an errno, or 0.
  [[nodiscard]] int keep() const;

 private:
  std::string name_, part_;
};

/// `cannot write "name": reason. remedy.` for an errno, or 0 for an unknown one. `left` is what there is of it, if anything.
[[nodiscard]] std::string unwritten(const std::string& name, int error, const std::string& left = {});

}  // namespace carom
