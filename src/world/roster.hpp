#pragma once
// All balls of a scene with their numbers: those written out, then those placed on lattices, then those of gases.

#include <string>
#include <vector>

#include "carom/scene/scene.hpp"
#include "carom/world/placement/region.hpp"

namespace carom {

/// Equal balls placed by a generator.
struct PlacedGroup {
  PlacedBalls balls;
  Number mass = 1.0;
  std::string material;
  int line = 0;
  Number radius_growth = 0.0;
};

struct Roster {
  Region region;                    ///< of the space; set by a gas where the scene has none
  std::vector<PlacedGroup> groups;  ///< in the order of their numbers, after the scene's balls

  [[nodiscard]] std::size_t placed() const;
};

/// Places what is generated. Throws InputError.
[[nodiscard]] Roster make_roster(const Scene& scene);

}  // namespace carom
