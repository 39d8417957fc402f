#include "carom/observe/speed_histogram.hpp"

#include <algorithm>
#include <cmath>

#include "maxwell.hpp"

namespace carom {

namespace {

constexpr double bins_to_the_rms_speed = 16;  // at first: the last bin ends at eight times it

double rms_speed(const Subject& s) {
  double squares = 0;
  for (std::uint32_t i = 0; i < s.mass.size(); ++i)
    if (s.moves_freely(i))
      for (const double v : s.velocity[i]) squares += v * v;
  return std::sqrt(squares / static_cast<double>(s.free));
}

}  // namespace

SpeedHistogram::SpeedHistogram(const Subject& subject)
    : dimension_(subject.dimension), width_(rms_speed(subject) / bins_to_the_rms_speed), moments_(subject.epoch_length) {
  for (std::uint32_t i = 0; i < subject.mass.size(); ++i) {
    if (!subject.moves_freely(i)) continue;
    const auto same =
        std::find_if(species_.begin(), species_.end(), [&](const Species& s) { return s.mass == subject.mass[i]; });
    if (same == species_.end()) {
      species_.push_back({subject.mass[i], 1});
    } else {
      ++same->count;
    }
  }
}

void SpeedHistogram::make_room(double speed) {
  if (width_ == 0) width_ = speed / bins_to_the_rms_speed;
  while (speed >= width_ * static_cast<double>(bins)) {
    for (std::size_t k = 0; k < bins / 2; ++k) time_[k] = time_[2 * k] + time_[2 * k + 1];
    std::fill(time_.begin() + bins / 2, time_.end(), 0.0);
    width_ *= 2;
  }
}

void SpeedHistogram::flight(const Flight& f) {
  const double path = f.path(), square = f.square();
  moments_.spread(f.begin, f.end,
                  {f.duration, path, square, std::sqrt(f.mass) * path, f.mass * square, f.mass * f.mass * f.fourth()});
  const double top = f.top_speed();
  make_room(top);
  if (top == 0) {
    time_[0] += f.duration;
  } else if (!(f.acceleration != Triple{})) {
    time_[static_cast<std::size_t>(top / width_)] += f.duration;
  } else {
    double below = 0;
    for (std::size_t k = 0; below < f.duration && k < bins; ++k) {
      const double next = k + 1 < bins ? std::max(below, f.time_below(static_cast<double>(k + 1) * width_)) : f.duration;
      time_[k] += next - below;
      below = next;
    }
  }
}

Estimates SpeedHistogram::estimates() const {
  using Sums = decltype(moments_)::Sums;
  const double d = dimension_, c = mean_length_ratio(d);
  return {moments_.estimate("speed_histogram.mean", [](const Sums& s) { return s[1] / s[0]; }),
          moments_.estimate("speed_histogram.mean_square", [](const Sums& s) { return s[2] / s[0]; }),
          moments_.estimate("speed_histogram.maxwell_mean",
                            [&](const Sums& s) { return s[3] / s[0] / (c * std::sqrt(s[4] / s[0])); }),
          moments_.estimate("speed_histogram.maxwell_fourth",
                            [&](const Sums& s) { return s[5] * s[0] / (s[4] * s[4]) * d / (d + 2); })};
}

double SpeedHistogram::maxwell_below(double speed, double temperature) const {
  double below = 0, count = 0;
  for (const Species& s : species_) {
    below += s.count * carom::maxwell_below(speed, temperature / s.mass, dimension_);
    count += s.count;
  }
  return below / count;
}

std::vector<SpeedBin> SpeedHistogram::table() const {
  const auto s = moments_.total();
  const double temperature = s[4] / (s[0] * dimension_);
  std::size_t used = bins;
  while (used > 0 && time_[used - 1] == 0) --used;
  std::vector<SpeedBin> list;
  for (std::size_t k = 0; k < used; ++k) {
    const double from = static_cast<double>(k) * width_, to = static_cast<double>(k + 1) * width_;
    list.push_back({from, to, time_[k] / s[0], maxwell_below(to, temperature) - maxwell_below(from, temperature)});
  }
  return list;
}

}  // namespace carom
