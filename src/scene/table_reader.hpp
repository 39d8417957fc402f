#pragma once
// Reads the keys of one table: takes each by name and type, then refuses what is left over.
// A key that is there but wrong leaves a placeholder and a problem; rules do not judge it again.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "keywords.hpp"
#include "report.hpp"

namespace carom::scene_text {

class TableReader {
 public:
  TableReader(Report& report, const toml::table& table, Path path);

  [[nodiscard]] Where where() const { return {report_.line(table_)}; }
  [[nodiscard]] bool has(std::string_view key) const { return table_.contains(key); }

  /// The value of a key, which is then known; null if it is not there.
  const toml::node* take(std::string_view key);

  void number(std::string_view key, Number& to);
  void number(std::string_view key, std::optional<Number>& to);
  void coordinates(std::string_view key, Coordinates& to);
  void vertices(std::string_view key, std::vector<Coordinates>& to);
  void integer(std::string_view key, int& to);
  void integer(std::string_view key, std::int64_t& to);
  void integer(std::string_view key, std::optional<std::int64_t>& to);
  void seed(std::string_view key, std::uint64_t& to);
  void flag(std::string_view key, bool& to);
  void text(std::string_view key, std::string& to);
  /// The elements of an array, whatever they are, as TOML.
  void values(std::string_view key, std::vector<std::string>& to);

  /// A word of a list. Returns false if the key is there and its word is none of them.
  template <class E>
  bool word(std::string_view key, std::span<const Word<E>> words, E& to);

  /// A table in this one; nothing if it is not there or is no table.
  std::optional<TableReader> table(std::string_view key);

  /// Calls read(TableReader, index) for each element of [[key]]; read(nothing, index) where it is no table.
  template <class Read>
  void tables(std::string_view key, Read read);

  /// A key that must be there.
  void require(std::string_view key, std::string_view why, std::string_view hint);

  /// A key that belongs to another kind of the same table.
  void misplaced(std::string_view key, std::string_view why);

  /// A key whose value asks for a feature that is not built.
  void unbuilt(std::string_view key);

  /// Refuses every key that was not taken, by the name of its feature or with the nearest known key.
  void finish();

  /// Nothing of this table is judged any more.
  void abandon() { report_.out_of_judgement(path_); }

  void refuse(std::string_view key, std::string what, std::string_view why, std::string hint = {});

  [[nodiscard]] const toml::table& source() const { return table_; }
  [[nodiscard]] const Path& path() const { return path_; }

 private:
  std::optional<Number> read_number(const toml::node& node, const Path& path);
  Coordinates read_coordinates(const toml::node& node, const Path& path);
  void wrong_type(const toml::node& node, const Path& path, std::string_view needed, std::string hint = {});
  std::optional<std::string> read_word(std::string_view key);
  void unknown_word(std::string_view key, const std::string& word, const std::vector<std::string_view>& known);
  [[nodiscard]] std::string feature(std::string_view key) const;
  const toml::array* read_tables(std::string_view key);

  Report& report_;
  const toml::table& table_;
  Path path_;
  std::vector<std::string_view> known_;
};

template <class E>
bool TableReader::word(std::string_view key, std::span<const Word<E>> words, E& to) {
  const bool there = has(key);
  const std::optional<std::string> word = read_word(key);
  if (!word) return !there;
  std::vector<std::string_view> known;
  for (const Word<E>& w : words) {
    known.push_back(w.text);
    if (w.text == *word) {
      to = w.value;
      return true;
    }
  }
  unknown_word(key, *word, known);
  return false;
}

template <class Read>
void TableReader::tables(std::string_view key, Read read) {
  const toml::array* array = read_tables(key);
  if (array == nullptr) return;
  for (std::size_t i = 0; i < array->size(); ++i) {
    const Path path = path_ / std::string(key) / std::to_string(i);
    const toml::table* element = array->get(i)->as_table();
    if (element == nullptr) {
      wrong_type(*array->get(i), path, "a table is needed");
      read(std::optional<TableReader>());
    } else {
      read(std::optional<TableReader>(std::in_place, report_, *element, path));
    }
  }
}

}  // namespace carom::scene_text
