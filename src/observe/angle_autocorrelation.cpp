#include "carom/observe/angle_autocorrelation.hpp"

#include <cmath>

namespace carom {

void AngleAutocorrelation::sample(const Snapshot& balls) {
  directions_ = balls.velocity;
  for (Triple& v : directions_) {
    const double speed = std::hypot(v[0], v[1], v[2]);
    for (double& component : v) component = speed > 0 ? component / speed : 0.0;
  }
  origins_.sample(directions_, [&](const Origins::Origin& origin, std::size_t lag) {
    double sum = 0, moving = 0;
    for (std::size_t i = 0; i < balls.size(); ++i) {
      double cosine = 0;
      for (std::size_t k = 0; k < 3; ++k) cosine += directions_[i][k] * origin.value[i][k];
      sum += cosine;
      moving += directions_[i] != Triple{} && origin.value[i] != Triple{} ? 1.0 : 0.0;
    }
    curve_.add(origin.number, lag, sum, moving);
  });
}

Estimates AngleAutocorrelation::estimates() const {
  return {curve_.estimate("angle_autocorrelation.time", [this](const std::vector<double>& c) {
    double sum = (c.front() + c.back()) / 2;
    for (std::size_t lag = 1; lag + 1 < c.size(); ++lag) sum += c[lag];
    return sum * curve_.step();
  })};
}

}  // namespace carom
