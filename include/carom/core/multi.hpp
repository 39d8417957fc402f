#pragma once
// Numbers of any precision (MPFR), and the scope that sets it.

#include <boost/multiprecision/eigen.hpp>
#include <boost/multiprecision/mpfr.hpp>

namespace carom {

/// A real of as many digits as the PrecisionScope that it was made in says. Results of operations have the larger precision
/// of their operands.
using Multi = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<0>, boost::multiprecision::et_off>;

/// While it lives, new numbers of type Real have `digits` digits; then those before. For Multi this is the state of the process
/// (before Boost 1.76), which operations on numbers of several precisions change as well: only one thread may compute with it.
/// Types of one precision are left alone.
template <class Real>
class PrecisionScope {
 public:
  explicit PrecisionScope(int) {}
};

template <>
class PrecisionScope<Multi> {
 public:
  explicit PrecisionScope(int digits) : before_(Multi::default_precision()) {
    Multi::default_precision(static_cast<unsigned>(digits));
  }
  ~PrecisionScope() { Multi::default_precision(before_); }
  PrecisionScope(const PrecisionScope&) = delete;
  PrecisionScope& operator=(const PrecisionScope&) = delete;

 private:
  unsigned before_;
};

}  // namespace carom
