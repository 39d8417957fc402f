#pragma once
// The moments at which frames are written: start + k every, without drift.

#include <cstdint>
#include <optional>

#include "carom/core/number.hpp"
#include "carom/core/rational.hpp"
#include "carom/scene/scene.hpp"

namespace carom::app {

class SampleTimes {
 public:
  /// None without `sample_every`. Times are exact rationals.
  explicit SampleTimes(const RunSpec& run);

  /// The next moment after the start that lies before the end of the run; none: no more.
  [[nodiscard]] std::optional<Number> next() const;
  void advance() { ++count_; }

  /// Leaves out the moments up to `time`.
  void skip_to(double time);

 private:
  [[nodiscard]] Rational moment() const { return start_ + Rational(count_) * every_; }

  Rational start_, every_;
  std::optional<Rational> end_;
  std::int64_t count_ = 1;
};

}  // namespace carom::app
