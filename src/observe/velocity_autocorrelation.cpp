#include "carom/observe/velocity_autocorrelation.hpp"

namespace carom {

void VelocityAutocorrelation::sample(const Snapshot& balls) {
  origins_.sample(balls.velocity, [&](const Origins::Origin& origin, std::size_t lag) {
    double sum = 0;
    for (std::size_t i = 0; i < balls.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) sum += balls.velocity[i][k] * origin.value[i][k];
    curve_.add(origin.number, lag, sum, static_cast<double>(balls.size()));
  });
}

Estimates VelocityAutocorrelation::estimates() const {
  const auto integral = [this](const std::vector<double>& c) {
    double sum = (c.front() + c.back()) / 2;
    for (std::size_t lag = 1; lag + 1 < c.size(); ++lag) sum += c[lag];
    return sum * curve_.step() / dimension_;
  };
  return {curve_.estimate("velocity_autocorrelation.initial", [](const auto& c) { return c.front(); }),
          curve_.estimate("velocity_autocorrelation.diffusion", integral)};
}

}  // namespace carom
