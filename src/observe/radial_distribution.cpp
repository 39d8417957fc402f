#include "carom/observe/radial_distribution.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

#include "carom/observe/enskog.hpp"
#include "maxwell.hpp"
#include "pair_distances.hpp"

namespace carom {

namespace {

using AnyPairs = std::variant<PairDistances<1>, PairDistances<2>, PairDistances<3>>;

AnyPairs pairs_in(int dimension, const Triple& edge, double range) {
  if (dimension == 1) return PairDistances<1>(edge, range);
  if (dimension == 2) return PairDistances<2>(edge, range);
  return PairDistances<3>(edge, range);
}

constexpr std::size_t terms = 4;  // of the polynomial at contact

/// The constant term of the polynomial that fits y(x) with weights w best. NaN where that is not determined.
class Fit {
 public:
  void add(double x, double y, double w) {
    std::array<double, terms> power{1.0};
    for (std::size_t k = 1; k < terms; ++k) power[k] = power[k - 1] * x;
    for (std::size_t r = 0; r < terms; ++r) {
      for (std::size_t c = 0; c < terms; ++c) matrix_[r][c] += w * power[r] * power[c];
      matrix_[r][terms] += w * power[r] * y;
    }
    ++points_;
  }
  /// Gauss's elimination from the highest power down: the matrix is positive definite.
  [[nodiscard]] double constant() const {
    if (points_ < terms) return std::numeric_limits<double>::quiet_NaN();
    auto m = matrix_;
    for (std::size_t p = terms; p-- > 1;)
      for (std::size_t r = 0; r < p; ++r) {
        const double factor = m[r][p] / m[p][p];
        for (std::size_t c = 0; c <= terms; ++c) m[r][c] -= factor * m[p][c];
      }
    return m[0][terms] / m[0][0];
  }

 private:
  std::array<std::array<double, terms + 1>, terms> matrix_{};
  std::size_t points_ = 0;
};

}  // namespace

struct RadialDistribution::Pairs {
  AnyPairs of;
};

RadialDistribution::RadialDistribution(const Settings& settings)
    : settings_(settings),
      pairs_(std::make_unique<Pairs>(Pairs{pairs_in(settings.dimension, settings.edge, settings.r_max)})),
      volume_(settings.edge[0] * settings.edge[1] * settings.edge[2]),
      sums_(settings.bins + contact_bins + 3) {}
RadialDistribution::~RadialDistribution() = default;
RadialDistribution::RadialDistribution(RadialDistribution&&) noexcept = default;

void RadialDistribution::sample(const Snapshot& balls) {
  count_ = static_cast<double>(balls.size());
  const std::span<double> row = sums_.row(sums_.units());
  const double per_length = static_cast<double>(settings_.bins) / settings_.r_max;
  const double sigma = settings_.diameter, near = sigma * (1 + contact_reach);
  const double per_shell = static_cast<double>(contact_bins) / (sigma * contact_reach);
  const auto take = [&](double square) {
    const double r = std::max(std::sqrt(square), sigma);  // balls that touch may overlap by a rounding
    const auto bin = static_cast<std::size_t>(r * per_length);
    row[bin < settings_.bins ? bin : settings_.bins - 1] += 1;
    if (r < near) {
      const auto shell = static_cast<std::size_t>((r - sigma) * per_shell);
      row[settings_.bins + std::min(shell, contact_bins - 1)] += 1;
    }
  };
  std::visit([&](auto& pairs) { pairs.each(balls.position, take); }, pairs_->of);
  row[settings_.bins + contact_bins] += 1;
  if (sigma > 0) count_collisions(balls, row);
}

void RadialDistribution::count_collisions(const Snapshot& balls, std::span<double> row) {
  const double kT = 2 * balls.kinetic / (settings_.dimension * (count_ - 1));
  const double speed = std::sqrt(kT / settings_.mass);
  if (sums_.units() > 1) {
    row[settings_.bins + contact_bins + 1] += static_cast<double>(balls.ball_ball - last_collisions_);
    row[settings_.bins + contact_bins + 2] += (balls.time - last_time_) * (speed + last_speed_) / 2;
  }
  last_time_ = balls.time;
  last_speed_ = speed;
  last_collisions_ = balls.ball_ball;
}

/// In one sample, if g were 1.
double RadialDistribution::pairs_expected(double from, double to) const {
  const double d = settings_.dimension;
  const double shell = sphere_area(settings_.dimension) / d * (std::pow(to, d) - std::pow(from, d));
  return count_ * (count_ - 1) / 2 * shell / volume_;
}

double RadialDistribution::contact(BlockRows::Row row) const {
  const double samples = row[settings_.bins + contact_bins], sigma = settings_.diameter;
  constexpr double width = contact_reach / contact_bins;
  Fit fit;
  for (std::size_t k = 0; k < contact_bins; ++k) {
    const double pairs = row[settings_.bins + k], from = static_cast<double>(k) * width;
    if (!(pairs > 0)) continue;
    const double g = pairs / (samples * pairs_expected(sigma * (1 + from), sigma * (1 + from + width)));
    fit.add(static_cast<double>(k) + 0.5, std::log(g), pairs);
  }
  return std::exp(fit.constant());
}

double RadialDistribution::contact_from_rate(BlockRows::Row row) const {
  const double d = settings_.dimension, collisions = row[settings_.bins + contact_bins + 1];
  const double thermal = row[settings_.bins + contact_bins + 2];
  const double flux = thermal / std::sqrt(std::numbers::pi) / mean_length_ratio(d * (count_ - 1));
  const double surface = sphere_area(settings_.dimension) * std::pow(settings_.diameter, d - 1);
  return 2 * collisions / count_ / ((count_ - 1) / volume_ * surface * flux);
}

Estimates RadialDistribution::estimates() const {
  Estimates list;
  if (!(settings_.diameter > 0)) return list;
  list.push_back(sums_.estimate("radial_distribution.contact", [this](BlockRows::Row row) { return contact(row); }));
  if (settings_.dimension > 1)
    list.push_back(
        sums_.estimate("radial_distribution.contact_rate", [this](BlockRows::Row row) { return contact_from_rate(row); }));
  return list;
}

Table RadialDistribution::table() const {
  const double width = settings_.r_max / static_cast<double>(settings_.bins);
  std::vector<double> pairs;
  for (std::size_t k = 0; k < settings_.bins; ++k)
    pairs.push_back(pairs_expected(static_cast<double>(k) * width, static_cast<double>(k + 1) * width));
  const Estimates g = sums_.estimates(std::vector<std::string>(settings_.bins), [&](BlockRows::Row row) {
    std::vector<double> values(settings_.bins);
    for (std::size_t k = 0; k < settings_.bins; ++k)
      values[k] = row[k] / (row[settings_.bins + contact_bins] * pairs[k]);
    return values;
  });
  Table table{"radial_distribution", {"from", "to", "g", "error"}, {}};
  for (std::size_t k = 0; k < settings_.bins; ++k)
    table.rows.push_back({static_cast<double>(k) * width, static_cast<double>(k + 1) * width, g[k].value, g[k].error});
  return table;
}

}  // namespace carom
