#pragma once
// What was measured as a function of something: a table for a file.

#include <string>
#include <vector>

namespace carom {

struct Table {
  std::string name;                       ///< of the quantity
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;  ///< as many numbers as columns; NaN: could not be measured
};

}  // namespace carom
