#include "energy_error.hpp"

#include <cmath>
#include <limits>

#include "carom/core/double_double.hpp"

namespace carom {

namespace {

/// One unit in the last place of |x|.
double ulp(double x) {
  const double size = std::abs(x);
  return std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
}

}  // namespace

double energy_error(const EnergyBalance& e) {
  return static_cast<double>((DoubleDouble(e.final) - DoubleDouble(e.initial)) +
                             (DoubleDouble(e.dissipated) - DoubleDouble(e.injected)));
}

double energy_error_ulp(const EnergyBalance& e) {
  const double initial = e.initial;
  if (initial == 0 || !std::isfinite(initial)) return std::numeric_limits<double>::quiet_NaN();
  return energy_error(e) / ulp(initial);
}

}  // namespace carom
