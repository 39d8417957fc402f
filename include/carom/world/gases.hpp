#pragma once
// A world whose gases still lie in plain arrays, for engines that give a million balls no record each.

#include <cstdint>
#include <vector>

#include "carom/core/page_vector.hpp"
#include "carom/world/world.hpp"

namespace carom {

/// The balls of one [[gas]]: equal but for their state. None touches anything, and none lies outside the cell.
struct GasBalls {
  double radius = 0.0;           ///< [length unit]
  double mass = 1.0;             ///< [mass unit]
  std::uint32_t material = 0;    ///< row of the restitution table
  PageVector<double> position;   ///< [length unit] at World::start; count x dimension, row by row
  PageVector<double> velocity;   ///< [length unit / L] the same
};

/// `world` is all of the scene but the gases, whose balls have the numbers after those that it holds, gas by gas.
template <int D>
struct WorldAndGases {
  World<double, D> world;
  std::vector<GasBalls> gases;

  [[nodiscard]] std::size_t size() const {
    std::size_t n = world.balls.size();
    for (const GasBalls& g : gases) n += g.position.size() / static_cast<std::size_t>(D);
    return n;
  }
};

/// As `build` in two steps: 16 D bytes a ball of a gas after the first. Throws InputError with every problem found.
template <int D>
[[nodiscard]] WorldAndGases<D> build_apart(const Scene& scene);

/// The world that `build` makes; the arrays are given back before the larger part of the records is made.
template <int D>
[[nodiscard]] World<double, D> join(WorldAndGases<D> parts);

extern template WorldAndGases<1> build_apart<1>(const Scene&);
extern template WorldAndGases<2> build_apart<2>(const Scene&);
extern template WorldAndGases<3> build_apart<3>(const Scene&);
extern template World<double, 1> join<1>(WorldAndGases<1>);
extern template World<double, 2> join<2>(WorldAndGases<2>);
extern template World<double, 3> join<3>(WorldAndGases<3>);

}  // namespace carom
