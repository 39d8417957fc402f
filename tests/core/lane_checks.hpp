#pragma once
// What four lanes compute, beside what doubles alone compute: counts of lanes whose bits differ. Compiled once a variant.

#include <cstdint>

namespace carom::testing {

struct LaneDifferences {
  std::int64_t looked_at = 0;
  std::int64_t wide = 0;    ///< sums, products and rounded sums of DoubleDouble
  std::int64_t dots = 0;    ///< sums in order
  std::int64_t order = 0;   ///< lanes not in order
  std::int64_t clock = 0;   ///< moments after a moment
  std::int64_t chosen = 0;  ///< numbers picked by bits
  std::int64_t squares = 0; ///< of 16-bit differences
};

namespace as_compiled {
LaneDifferences lane_differences();
}
namespace for_v3 {
LaneDifferences lane_differences();
}

}  // namespace carom::testing
