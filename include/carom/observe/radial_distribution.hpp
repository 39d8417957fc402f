#pragma once
// How the centres of balls lie around each other: g(r), and its value at contact.

#include <cstdint>
#include <memory>

#include "carom/observe/block_rows.hpp"
#include "carom/observe/snapshot.hpp"
#include "carom/observe/table.hpp"

namespace carom {

/// In a periodic cell of volume V, from samples of all pairs nearer than r_max:
///   g(r) = pairs in r .. r + dr, over N (N - 1)/2 times the volume of the shell over V,
/// so that points without a part in each other have g = 1 at any N. All balls of finite mass count, whatever their size.
///
/// For equal balls of diameter sigma also the value at contact, twice:
///   radial_distribution.contact: ln g in 20 shells between sigma and 1.1 sigma, by least squares weighted with the
///   pairs in each, is a polynomial of third degree in r; its value at sigma.
///   radial_distribution.contact_rate (above one dimension): from the collisions counted between the samples,
///   2 collisions / (N t) = omega (N - 1)/V sigma^(d-1) g sqrt(kT/(pi m)) / c,
///   omega and kT as in enskog_free_time and VirialPressure, and c = sqrt(2/D_f) Gamma((D_f + 1)/2) / Gamma(D_f/2) for
///   fixed energy and momentum. Then Z = 1 + omega sigma^d g (N - 1) / (2 d V) for elastic balls.
/// Errors come from blocks of samples.
class RadialDistribution {
 public:
  struct Settings {
    int dimension = 3;
    Triple edge{1, 1, 1};    ///< [length] of the periodic cell; 1 beyond the dimension
    double r_max = 0.0;      ///< [length] <= half of the shortest edge
    std::size_t bins = 200;  ///< between 0 and r_max
    double diameter = 0.0;   ///< [length] sigma; 0: no value at contact
    double mass = 0.0;       ///< [mass] of each ball; only with a diameter
  };

  explicit RadialDistribution(const Settings& settings);
  ~RadialDistribution();
  RadialDistribution(RadialDistribution&&) noexcept;

  void sample(const Snapshot& balls);

  [[nodiscard]] Estimates estimates() const;

  /// Columns: from, to, g, error.
  [[nodiscard]] Table table() const;

 private:
  static constexpr std::size_t contact_bins = 20;
  static constexpr double contact_reach = 0.1;  ///< [sigma]
  struct Pairs;

  [[nodiscard]] double pairs_expected(double from, double to) const;
  [[nodiscard]] double contact(BlockRows::Row row) const;
  [[nodiscard]] double contact_from_rate(BlockRows::Row row) const;
  void count_collisions(const Snapshot& balls, std::span<double> row);

  Settings settings_;
  std::unique_ptr<Pairs> pairs_;
  double volume_, count_ = 0.0;  // of the balls
  BlockRows sums_;               // bins; bins near contact; samples; collisions; time times sqrt(kT/m)
  double last_time_ = 0.0, last_speed_ = 0.0;
  std::int64_t last_collisions_ = 0;
};

}  // namespace carom
