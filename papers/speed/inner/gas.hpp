#pragma once
// The world of a warm gas of spheres, for benchmarks of inner pieces.

#include <cstdint>

#include "carom/motion/free_flight.hpp"
#include "carom/world/build.hpp"

namespace carom::speed {

using Flight = FreeFlight<double, 3>;
using WorldType = World<double, 3>;

/// Spheres of diameter 1 in a periodic cube at packing fraction 0.49, as they are placed.
inline WorldType spheres(std::int64_t count) {
  Scene scene;
  scene.dimension = 3;
  scene.run.events = 0;
  GasSpec gas;
  gas.count = count;
  gas.radius = Number(0.5);
  gas.packing_fraction = Number(0.49);
  scene.gases = {gas};
  return build<double, 3>(scene);
}

}  // namespace carom::speed
