#pragma once
// Moments from which later ones are looked back at: origins in turn, so that curves over lags overlap.

#include <cstddef>
#include <vector>

#include "carom/observe/subject.hpp"

namespace carom {

/// `count` origins at most are kept at a time, evenly staggered over lags 0 .. lags; each holds one vector a ball.
class Origins {
 public:
  struct Origin {
    std::size_t number = 0;  ///< how many were made before it
    std::size_t at = 0;      ///< its sample
    std::vector<Triple> value;
  };

  /// count >= 1.
  Origins(std::size_t lags, std::size_t count) : lags_(lags), spacing_((lags + count) / count), slots_(count) {}

  /// Sample number 0, 1, 2, ... is `value`: calls f(origin, lag) for every origin that is `lags` samples old or less, itself
  /// too where it becomes one.
  template <class F>
  void sample(const std::vector<Triple>& value, F&& f) {
    if (sample_ % spacing_ == 0) {
      Origin& next = slots_[made_ % slots_.size()];
      next.number = made_++;
      next.at = sample_;
      next.value = value;
    }
    for (const Origin& origin : slots_)
      if (!origin.value.empty() && sample_ - origin.at <= lags_) f(origin, sample_ - origin.at);
    ++sample_;
  }

 private:
  std::size_t lags_, spacing_;
  std::vector<Origin> slots_;
  std::size_t sample_ = 0, made_ = 0;
};

/// How many origins are kept where nothing is said: 10, fewer where that would be more than 10^6 vectors, at least 1.
[[nodiscard]] constexpr std::size_t usual_origins(std::size_t balls) {
  const std::size_t fit = balls == 0 ? 10 : 1'000'000 / balls;
  return fit < 1 ? 1 : fit > 10 ? 10 : fit;
}

}  // namespace carom
