#pragma once
// From balls, one after the other, to a swarm.

#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>

#include "carom/world/gases.hpp"
#include "carom/world/swarm.hpp"

namespace carom {

/// What balls of one species have in common: radius, mass, material, fixed.
using Alike = std::tuple<double, double, std::uint32_t, bool>;

/// Judges, ball by ball, whether they can be stored as a swarm: lone balls of positive radius, all alive, none in a contact
/// other than that of its last collision, which ended where its stored state begins.
template <int D>
class SwarmJudge {
 public:
  void add(const Ball<double, D>& ball, const BallDetail<double, D>& detail);
  [[nodiscard]] bool fit() const noexcept { return fit_; }

 private:
  bool fit_ = true;
  std::map<Alike, bool> kinds_;
};

/// Fills the rows of a swarm by the numbers of balls that a SwarmJudge has found fit.
template <int D>
class SwarmMaker {
 public:
  /// `rest` holds all of the world but its balls.
  SwarmMaker(World<double, D>&& rest, std::size_t balls);
  void add(std::uint32_t number, const Ball<double, D>& ball, const BallDetail<double, D>& detail);
  [[nodiscard]] Swarm<D> finish();

 private:
  Swarm<D> swarm_;
  std::map<Alike, std::uint16_t> kinds_;
};

/// True if all its balls are fit, and there are any.
template <int D>
[[nodiscard]] bool is_swarm(const World<double, D>& world);
template <int D>
[[nodiscard]] bool is_swarm(const WorldAndGases<D>& parts);

/// The balls are taken out of `world`, or of `parts`, and their arrays given back.
template <int D>
[[nodiscard]] Swarm<D> make_swarm(World<double, D>&& world);
template <int D>
[[nodiscard]] Swarm<D> make_swarm(WorldAndGases<D>&& parts);

extern template class SwarmJudge<2>;
extern template class SwarmJudge<3>;
extern template class SwarmMaker<2>;
extern template class SwarmMaker<3>;
extern template bool is_swarm(const World<double, 2>&);
extern template bool is_swarm(const World<double, 3>&);
extern template bool is_swarm(const WorldAndGases<2>&);
extern template bool is_swarm(const WorldAndGases<3>&);
extern template Swarm<2> make_swarm(World<double, 2>&&);
extern template Swarm<3> make_swarm(World<double, 3>&&);
extern template Swarm<2> make_swarm(WorldAndGases<2>&&);
extern template Swarm<3> make_swarm(WorldAndGases<3>&&);

}  // namespace carom
