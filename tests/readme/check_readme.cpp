// check_readme SOURCE CAROM PROGRAM FOLDER: runs what the README shows, in FOLDER, and compares what it prints.
//
// FOLDER is made to look like a checkout that quickstart.sh has built: build/release/carom, examples/. Of the README's
// blocks,
//   toml     is written to the file that its first line names;
//   console  holds commands ("$ ...") and below each what it prints, compared line by line but for the line "took";
//   text     is what PROGRAM, the README's C++ program, prints;
//   sh       names scripts, which must be there and have no syntax errors.

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

struct Block {
  std::string kind;
  std::vector<std::string> lines;
};

std::vector<Block> blocks_of(const fs::path& readme) {
  std::ifstream in(readme);
  if (!in) throw std::runtime_error("cannot read " + readme.string());
  std::vector<Block> blocks;
  bool inside = false;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("```")) {
      inside = !inside;
      if (inside) blocks.push_back({line.substr(3), {}});
    } else if (inside) {
      blocks.back().lines.push_back(line);
    }
  }
  return blocks;
}

std::vector<std::string> printed_by(const std::string& command) {
  std::FILE* pipe = popen(("{ " + command + "\n} 2>&1").c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot start " + command);
  std::string text;
  std::array<char, 4096> part;
  while (const std::size_t n = std::fread(part.data(), 1, part.size(), pipe)) text.append(part.data(), n);
  pclose(pipe);
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

bool varies(const std::string& line) { return line.starts_with("  took "); }

class Checker {
 public:
  explicit Checker(std::string program) : program_(std::move(program)) {}

  void check(const Block& block) {
    if (block.kind == "toml") write(block);
    if (block.kind == "console") run(block);
    if (block.kind == "text") compare(program_, block.lines);
    if (block.kind == "sh")
      for (const std::string& line : block.lines) compare("bash -n " + line.substr(line.find(' ') + 1), {});
  }
  [[nodiscard]] int commands() const { return commands_; }
  [[nodiscard]] int differences() const { return differences_; }

 private:
  static void write(const Block& block) {
    std::ofstream out(block.lines.at(0).substr(2));
    for (const std::string& line : block.lines) out << line << '\n';
  }

  void run(const Block& block) {
    for (std::size_t i = 0; i < block.lines.size();) {
      if (!block.lines[i].starts_with("$ ")) throw std::runtime_error("no command: " + block.lines[i]);
      const std::string command = block.lines[i++].substr(2);
      std::vector<std::string> shown;
      while (i < block.lines.size() && !block.lines[i].starts_with("$ ")) shown.push_back(block.lines[i++]);
      compare(command, shown);
    }
  }

  void compare(const std::string& command, const std::vector<std::string>& shown) {
    ++commands_;
    const std::vector<std::string> printed = printed_by(command);
    bool same = printed.size() == shown.size();
    for (std::size_t i = 0; same && i < shown.size(); ++i)
      same = printed[i] == shown[i] || (varies(printed[i]) && varies(shown[i]));
    if (same) return;
    ++differences_;
    std::cout << "README.md shows something else than\n$ " << command << '\n';
    for (const std::string& line : printed) std::cout << line << '\n';
  }

  std::string program_;
  int commands_ = 0, differences_ = 0;
};

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 5) throw std::runtime_error("usage: check_readme SOURCE CAROM PROGRAM FOLDER");
  const fs::path source = argv[1], folder = argv[4];
  fs::remove_all(folder);
  fs::create_directories(folder / "build/release");
  fs::create_symlink(argv[2], folder / "build/release/carom");
  for (const char* name : {"examples", "tests", "src"}) fs::create_directory_symlink(source / name, folder / name);
  fs::current_path(folder);

  Checker checker(argv[3]);
  for (const Block& block : blocks_of(source / "README.md")) checker.check(block);
  std::cout << checker.commands() << " commands, " << checker.differences() << " differ\n";
  return checker.commands() > 0 && checker.differences() == 0 ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
