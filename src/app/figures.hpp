#pragma once
// What there is to draw in a folder of results, as scripts of gnuplot.

#include <string>
#include <vector>

namespace carom::app {

struct Figure {
  std::string name;    ///< of its files, without an ending
  std::string script;  ///< from the settings to the plots, data included; the terminal and the output come before
};

struct Figures {
  std::vector<Figure> list;
  std::vector<std::string> missing;  ///< sentences: what is not there, and what would make it
};

/// Of the tables in `folder`: the balance of energy (a ledger), collisions per time (an event log), speeds beside Maxwell's
/// curve (a speed histogram, or else the frames of a trajectory), and every other table, its columns over the first one.
/// Long tables are thinned to some thousand points. Throws InputError.
[[nodiscard]] Figures figures_in(const std::string& folder);

}  // namespace carom::app
