#include "carom/observe/mean_squared_displacement.hpp"

namespace carom {

void MeanSquaredDisplacement::sample(const Snapshot& balls) {
  origins_.sample(balls.position, [&](const Origins::Origin& origin, std::size_t lag) {
    double sum = 0;
    for (std::size_t i = 0; i < balls.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const double d = balls.position[i][k] - origin.value[i][k];
        sum += d * d;
      }
    curve_.add(origin.number, lag, sum, static_cast<double>(balls.size()));
  });
}

Estimates MeanSquaredDisplacement::estimates() const {
  const auto diffusion = [this](const std::vector<double>& msd) {
    const std::size_t last = curve_.lags(), first = last / 2;
    const double middle = static_cast<double>(first + last) / 2;
    double above = 0, below = 0;
    for (std::size_t lag = first; lag <= last; ++lag) {
      const double x = static_cast<double>(lag) - middle;
      above += x * msd[lag];
      below += x * x;
    }
    return above / below / curve_.step() / (2 * dimension_);
  };
  return {curve_.estimate(as_ == Named::diffusion ? "diffusion.coefficient" : "mean_squared_displacement.diffusion", diffusion)};
}

}  // namespace carom
