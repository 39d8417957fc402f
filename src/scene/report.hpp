#pragma once
// What is being read, and every problem found in it: knows for each node where it was written.

#include <set>
#include <string>
#include <vector>

#include <toml++/toml.h>

#include "carom/core/error.hpp"
#include "carom/scene/read.hpp"
#include "document.hpp"
#include "path.hpp"

namespace carom::scene_text {

class Report {
 public:
  Report(std::string_view text, std::string file, const std::vector<Override>& overrides);

  /// The scene file as a table. A syntax error is a problem; the table is then empty.
  [[nodiscard]] toml::table parse_file();

  /// The value of an override as `key = value` of a table: TOML if it is that, else a string.
  [[nodiscard]] toml::table parse_override(std::size_t index);

  /// The line of the scene file; 0 for what an override has set.
  [[nodiscard]] int line(const toml::node& node) const;

  [[nodiscard]] std::string literal(const toml::node& number);

  /// A problem with the key at `path`, which rules need not judge any more.
  void refuse(const toml::node& at, const Path& path, std::string what, std::string why, std::string hint = {});

  /// A problem at a node, by which no key is out of judgement.
  void add(const toml::node* at, std::string what, std::string why, std::string hint = {});
  void add(const toml::source_region& at, std::string what, std::string why, std::string hint = {});
  void add_override(std::size_t index, std::string what, std::string why, std::string hint = {});

  void out_of_judgement(const Path& path) { refused_.insert(path); }
  [[nodiscard]] bool judged(const Path& path) const { return !touches(refused_, path); }

  [[nodiscard]] const std::vector<Override>& overrides() const { return overrides_; }

  /// All problems, in the order of the file; those of overrides last.
  [[nodiscard]] std::vector<Problem> problems() const;

 private:
  [[nodiscard]] std::size_t document(const toml::source_region& at) const;

  std::string file_;
  const std::vector<Override>& overrides_;
  std::vector<Document> documents_;  // the file, then one for each override
  std::vector<Problem> problems_;
  std::set<Path> refused_;
};

}  // namespace carom::scene_text
