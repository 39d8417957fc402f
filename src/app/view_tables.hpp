#pragma once
// Measured tables for the page of `carom view`: {name, columns: [{label, values}]}, the first column to the right.

#include <string>
#include <vector>

#include "carom/observe/speed_histogram.hpp"
#include "carom/observe/table.hpp"
#include "write/json_text.hpp"

namespace carom::app {

[[nodiscard]] Json table_of(const std::vector<SpeedBin>& speeds);
[[nodiscard]] Json table_of(const Table& table);

/// Those among the *.csv of a folder that are tables of numbers: a header, then at most `longest_table` lines. Logs and
/// trajectories are none.
[[nodiscard]] Json tables_in(const std::string& folder);

inline constexpr std::size_t longest_table = 5000;

}  // namespace carom::app
