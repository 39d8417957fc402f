#pragma once
// The coefficient of restitution of every combination of materials and walls, looked up once when the world is built.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace carom {

/// e [-] between two materials and between a material and a wall. Material 0 is "none".
template <class Real>
class RestitutionTable {
 public:
  RestitutionTable() = default;
  RestitutionTable(std::size_t materials, std::size_t walls)
      : materials_(materials), between_(materials * materials, Real(1)), at_wall_(materials * walls, Real(1)) {}

  [[nodiscard]] const Real& between(std::uint32_t a, std::uint32_t b) const { return between_[a * materials_ + b]; }
  [[nodiscard]] const Real& at_wall(std::uint32_t material, std::uint32_t wall) const {
    return at_wall_[wall * materials_ + material];
  }
  [[nodiscard]] bool any_below_one() const {
    const auto below = [](const Real& e) { return e < 1; };
    return std::any_of(between_.begin(), between_.end(), below) || std::any_of(at_wall_.begin(), at_wall_.end(), below);
  }
  /// The table with f(e) in the place of every e.
  template <class F>
  [[nodiscard]] RestitutionTable mapped(F&& f) const {
    RestitutionTable table = *this;
    std::transform(between_.begin(), between_.end(), table.between_.begin(), f);
    std::transform(at_wall_.begin(), at_wall_.end(), table.at_wall_.begin(), f);
    return table;
  }
  /// All values, for a fingerprint.
  [[nodiscard]] std::vector<Real> values() const {
    std::vector<Real> all = between_;
    all.insert(all.end(), at_wall_.begin(), at_wall_.end());
    return all;
  }
  void set_between(std::uint32_t a, std::uint32_t b, const Real& e) {
    between_[a * materials_ + b] = e;
    between_[b * materials_ + a] = e;
  }
  void set_at_wall(std::uint32_t material, std::uint32_t wall, const Real& e) {
    at_wall_[wall * materials_ + material] = e;
  }

 private:
  std::size_t materials_ = 0;
  std::vector<Real> between_, at_wall_;
};

}  // namespace carom
