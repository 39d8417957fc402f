#pragma once
// Lines and numbers of a text file, with its name and line number at hand for messages.

#include <cstdint>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "carom/core/error.hpp"
#include "carom/core/number.hpp"
#include "carom/write/frame_reader.hpp"

namespace carom {

class LineReader {
 public:
  /// Throws InputError if the file cannot be opened.
  explicit LineReader(const std::string& path);

  /// The next line without its end; false at the end of the file.
  bool next(std::string& line);

  /// What is wrong with the line that was read last.
  [[noreturn]] void refuse(const std::string& what, const std::string& why, const std::string& hint = {}) const;

  /// A number, whose text is kept where it says more than its double.
  [[nodiscard]] Number number(std::string_view text) const;
  [[nodiscard]] std::int64_t integer(std::string_view text) const;

  [[nodiscard]] const std::string& path() const noexcept { return path_; }

 private:
  std::string path_;
  std::ifstream in_;
  int line_ = 0;
};

/// The words between blanks.
[[nodiscard]] std::vector<std::string_view> words_of(std::string_view line);

/// The cells between commas.
[[nodiscard]] std::vector<std::string_view> cells_of(std::string_view line);

[[nodiscard]] std::unique_ptr<FrameReader> read_csv_frames(const std::string& path);
[[nodiscard]] std::unique_ptr<FrameReader> read_xyz_frames(const std::string& path);
[[nodiscard]] std::unique_ptr<FrameReader> read_sph_frames(const std::string& path);
[[nodiscard]] std::unique_ptr<FrameReader> read_h5md_frames(const std::string& path);

}  // namespace carom
