#include "sample_times.hpp"

namespace carom::app {

SampleTimes::SampleTimes(const RunSpec& run) {
  if (!run.sample_every) return;
  start_ = exact(run.start);
  every_ = exact(*run.sample_every);
  if (run.until) end_ = exact(*run.until);
}

void SampleTimes::skip_to(double time) {
  if (every_ <= 0) return;
  const Rational periods = (exact(Number(time)) - start_) / every_;
  if (periods >= 1) count_ = static_cast<std::int64_t>(numerator(periods) / denominator(periods)) + 1;
}

std::optional<Number> SampleTimes::next() const {
  if (every_ <= 0) return std::nullopt;
  const Rational t = moment();
  if (end_ && t >= *end_) return std::nullopt;
  Number number = nearest_double(t);
  number.text = t.str();
  return number;
}

}  // namespace carom::app
