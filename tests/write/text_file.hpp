#pragma once
// A file of a test, read back as lines and cells.

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace carom::test {

/// A folder that is removed at the end of a test.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "carom-test-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(file(name), std::ios::binary) << text;
  }
  [[nodiscard]] std::string read(const std::string& name) const {
    std::ifstream in(file(name), std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
  }
  [[nodiscard]] std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path_))
      if (entry.is_regular_file()) names.push_back(entry.path().filename().string());
    return names;
  }

 private:
  std::filesystem::path path_;
};

inline std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

/// A table with # comments, a header and rows.
struct Csv {
  std::vector<std::string> comments, header;
  std::vector<std::map<std::string, std::string>> rows;
  bool whole = true;  ///< every line is ended, and every row has the header's number of cells

  explicit Csv(const std::string& text) {
    std::vector<std::string> lines = split(text, '\n');
    whole = lines.back().empty();
    lines.pop_back();
    for (const std::string& line : lines) {
      if (line.starts_with('#')) {
        comments.push_back(line);
      } else if (header.empty()) {
        header = split(line, ',');
      } else {
        const std::vector<std::string> cells = split(line, ',');
        whole = whole && cells.size() == header.size();
        auto& row = rows.emplace_back();
        for (std::size_t k = 0; k < cells.size() && k < header.size(); ++k) row[header[k]] = cells[k];
      }
    }
  }
};

}  // namespace carom::test
