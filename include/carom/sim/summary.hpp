#pragma once
// The result of a run, in the user's units. Physical numbers have a text where the run was not in double: all their digits.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "carom/core/number.hpp"
#include "carom/sim/books.hpp"
#include "carom/sim/stop.hpp"

namespace carom {

struct EnergyBalance {
  Number initial = 0.0;         ///< kinetic + potential at the start
  Number final = 0.0;           ///< the same at the end
  Number dissipated = 0.0;      ///< by impacts
  Number injected = 0.0;        ///< by moving walls, balls of infinite mass, growth and rescaling
  Number relative_error = 0.0;  ///< |final + dissipated - initial - injected| / largest energy in play
};

struct VectorBalance {
  std::vector<Number> initial, final;
  std::optional<Number> relative_error;  ///< none where walls, forces or infinite masses change it
};

struct BallState {
  std::uint32_t index = 0;
  std::string name;
  std::vector<Number> position;  ///< wrapped
  std::vector<std::int64_t> image;
  std::vector<Number> unwrapped_position;
  std::vector<Number> velocity;
  Number radius = 0.0;
  Number mass = 1.0;
};

struct ExactnessSummary {
  Number max_gap_error = 0.0;           ///< [length]
  Number max_gap_error_relative = 0.0;  ///< over the sum of the radii in contact
  std::int64_t clamped = 0;
  std::int64_t unresolved = 0;
  std::int64_t singular = 0;
  std::int64_t summed_bounces = 0;
  std::int64_t repredicted = 0;
};

/// Of balls that grow.
struct GrowthSummary {
  std::optional<double> packing_fraction;  ///< [-] share of the space that all balls fill; none in an open space
  std::optional<double> reduced_pressure;  ///< [-] p V / (N k_B T) over the last block of collisions; none before the first
};

struct StopDetail {
  std::string reason;
  std::vector<std::uint32_t> balls;
  Number time = 0.0;
};

struct Summary {
  std::string title;
  int dimension = 2;
  std::int64_t balls = 0;
  std::string composition;
  std::string precision = "double";
  std::uint64_t seed = 0;
  double epoch_length = 1.0;
  Number time = 0.0;
  Stop stopped_by = Stop::until;
  std::optional<StopDetail> stopped;  ///< with collapse and non_finite
  EventCounts events;
  EnergyBalance energy;
  VectorBalance momentum, angular_momentum;
  ExactnessSummary exactness;
  std::optional<GrowthSummary> growth;
};

}  // namespace carom
