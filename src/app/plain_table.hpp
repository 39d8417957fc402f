#pragma once
// A table that carom wrote, as numbers.

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace carom::app {

struct PlainTable {
  std::string kind;                 ///< "event log", "ledger", ...: from its first comment; empty: no table of carom
  std::string title;                ///< of its run
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;  ///< nan for an empty cell, or one that is no number

  /// The number of a column.
  [[nodiscard]] std::optional<std::size_t> find(const std::string& name) const;
};

/// Without its rows, each of which is handed to `take` instead, where there is one. Throws InputError.
[[nodiscard]] PlainTable read_table(const std::string& path, const std::function<void(const std::vector<double>&)>& take = {});

}  // namespace carom::app
