#pragma once
// What the tables of a run say about themselves, in lines that start with #.

#include <string>
#include <string_view>

#include "carom/sim/simulation.hpp"
#include "carom/write/output_file.hpp"

namespace carom {

/// `what` is the kind of table: "event log".
void write_head_comments(OutputFile& file, std::string_view what, const Simulation& simulation, const std::string& title);

/// Epoch length 0: not known, and left out.
void write_head_comments(OutputFile& file, std::string_view what, const std::string& title, int dimension, double epoch_length);

/// Appends ",x,y,z" with a prefix before each letter, as many as there are dimensions.
void append_columns(std::string& line, std::string_view prefix, int dimension);

}  // namespace carom
