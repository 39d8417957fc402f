#pragma once
// The result of a run, in the user's units.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "carom/sim/books.hpp"
#include "carom/sim/stop.hpp"

namespace carom {

struct EnergyBalance {
  double initial = 0.0;         ///< kinetic + potential at the start
  double final = 0.0;           ///< the same at the end
  double dissipated = 0.0;      ///< by impacts
  double injected = 0.0;        ///< by moving walls and balls of infinite mass
  double relative_error = 0.0;  ///< |final + dissipated - initial - injected| / largest energy in play
};

struct VectorBalance {
  std::vector<double> initial, final;
  std::optional<double> relative_error;  ///< none where walls, forces or infinite masses change it
};

struct BallState {
  std::uint32_t index = 0;
  std::string name;
  std::vector<double> position;  ///< wrapped
  std::vector<std::int64_t> image;
  std::vector<double> unwrapped_position;
  std::vector<double> velocity;
  double radius = 0.0;
  double mass = 1.0;
};

struct ExactnessSummary {
  double max_gap_error = 0.0;           ///< [length]
  double max_gap_error_relative = 0.0;  ///< over the sum of the radii in contact
  std::int64_t clamped = 0;
  std::int64_t unresolved = 0;
  std::int64_t singular = 0;
  std::int64_t repredicted = 0;
};

struct StopDetail {
  std::string reason;
  std::vector<std::uint32_t> balls;
  double time = 0.0;
};

struct Summary {
  std::string title;
  int dimension = 2;
  std::int64_t balls = 0;
  std::string composition;
  std::string precision = "double";
  std::uint64_t seed = 0;
  double epoch_length = 1.0;
  double time = 0.0;
  Stop stopped_by = Stop::until;
  std::optional<StopDetail> stopped;  ///< with collapse and non_finite
  EventCounts events;
  EnergyBalance energy;
  VectorBalance momentum, angular_momentum;
  ExactnessSummary exactness;
};

}  // namespace carom
