#pragma once
// Runs a scene to its end and gives what was measured.

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "carom/observe/observers.hpp"

namespace carom::testing {

struct Measured {
  Estimates list;
  std::optional<std::vector<SpeedBin>> speeds;
  Summary summary;

  [[nodiscard]] const Estimate& at(const std::string& name) const {
    for (const Estimate& e : list)
      if (e.name == name) return e;
    throw std::out_of_range("nothing measured is called " + name);
  }
  [[nodiscard]] double operator[](const std::string& name) const { return at(name).value; }
};

[[nodiscard]] inline Measured measure(const Scene& scene) {
  Simulation simulation(scene);
  Observers observers(scene, simulation);
  simulation.run(observers.sink());
  observers.end(simulation);
  return {observers.estimates(), observers.speed_table(), simulation.summary()};
}

}  // namespace carom::testing
