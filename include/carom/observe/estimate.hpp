#pragma once
// A measured quantity under its name.

#include <limits>
#include <string>
#include <vector>

namespace carom {

/// Dots in a name part the levels of `observed`: pressure.Z. What could not be measured is NaN.
struct Estimate {
  std::string name;
  double value = std::numeric_limits<double>::quiet_NaN();
  double error = std::numeric_limits<double>::quiet_NaN();  ///< one standard error
};

using Estimates = std::vector<Estimate>;

}  // namespace carom
