#pragma once
// Lyapunov exponents: how fast small displacements grow, direction by direction.

#include <cstdint>
#include <optional>
#include <vector>

#include "carom/observe/block_rows.hpp"
#include "carom/observe/finite_time.hpp"
#include "carom/observe/observer.hpp"
#include "carom/observe/table.hpp"
#include "carom/observe/tangent_flow.hpp"

namespace carom {

/// The exponents of the flow in the 2 N D positions and velocities of the N balls that move freely, by their exact tangent map
/// [Benettin1980; papers/tangent_map.md, eq. 9], the largest K of them or all:
///   lyapunov.exponents[0], [1], ... [1/time], the largest first;
/// and where all are measured
///   lyapunov.sum [1/time]: the rate at which volumes grow: 0 where energy is conserved;
///   lyapunov.entropy [1/time]: the sum of the positive ones, the rate of Kolmogorov and Sinai where Pesin's formula holds;
///   lyapunov.dimension: Kaplan and Yorke's, only where the sum is negative beyond its error.
/// Errors are those of blocks. Exponents that are exactly 0 are approached as ln(t) / t, from above.
/// With `finite_time`, those over spans of that length: see FiniteTime.
///
/// Displacements are made orthonormal when one has grown a thousandfold, or every `every`; so the directions of the
/// fastest and the slowest still differ by far more than rounding. T of eq. 9 is about the shortest length over the largest
/// speed of the start.
class Lyapunov {
 public:
  Lyapunov(const LyapunovSpec& spec, const Scene& scene, const Subject& subject);

  void collision(const Collision& c, double t, const Subject& subject);
  void end(double t);
  [[nodiscard]] Estimates estimates() const;

  /// Of the finite-time exponents; none: not asked for.
  [[nodiscard]] std::optional<Table> table() const;

  /// How many of the exponents of `subject` are measured.
  [[nodiscard]] static std::size_t count(const LyapunovSpec& spec, const Subject& subject);

 private:
  void orthonormalise(const Time<double>& now);
  void finish_spans(const Time<double>& now);

  double epoch_length_;           // [time]
  Time<double> begun_;
  std::size_t coordinates_;       // of phase space
  TangentFlow flow_;
  std::optional<double> every_;   // [time]
  Time<double> done_;             // the displacements were orthonormal then
  std::size_t passed_ = 0;        // times that they were made so
  BlockRows sums_;                // ln l_k of each, and the time
  std::vector<double> logs_, along_;
  std::optional<FiniteTime> spans_;
};

}  // namespace carom
