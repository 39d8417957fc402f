#include "csv_comments.hpp"

#include <fmt/core.h>

#include "carom/write/number_text.hpp"

namespace carom {

namespace {

// A title may hold line breaks; a comment may not.
std::string on_one_line(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  return text;
}

}  // namespace

void write_head_comments(OutputFile& file, std::string_view what, const Simulation& simulation, const std::string& title) {
  write_head_comments(file, what, title, simulation.dimension(), simulation.epoch_length());
}

void write_head_comments(OutputFile& file, std::string_view what, const std::string& title, int dimension, double epoch_length) {
  file.line() += fmt::format("# carom {}\n", what);
  file.line() += fmt::format("# title: {}\n", on_one_line(title));
  file.line() += fmt::format("# dimension: {}", dimension);
  file.end_line();
  if (epoch_length == 0) return;
  file.line() += fmt::format("# epoch_length: {} = {}", hex_text(epoch_length), number_text(epoch_length));
  file.end_line();
}

void append_columns(std::string& line, std::string_view prefix, int dimension) {
  for (int k = 0; k < dimension; ++k) {
    line += ',';
    line += prefix;
    line += "xyz"[k];
  }
}

}  // namespace carom
