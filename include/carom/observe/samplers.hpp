#pragma once
// What [observe] asks for that is looked at now and then, at equal distances of time, and not collision by collision.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "carom/observe/angle_autocorrelation.hpp"
#include "carom/observe/snapshot.hpp"
#include "carom/observe/mean_squared_displacement.hpp"
#include "carom/observe/radial_distribution.hpp"
#include "carom/observe/velocity_autocorrelation.hpp"
#include "carom/scene/scene.hpp"
#include "carom/sim/simulation.hpp"

namespace carom {

/// What is looked at next: when the run has reached a moment, or so many collisions since its start.
struct Appointment {
  std::optional<Number> time;          ///< [time]
  std::optional<std::int64_t> events;
};

/// Usage: take the simulation to `next()`, call `look`, and so on. A run goes the same way with it and without, and the
/// engine runs at full speed between the looks. Samples are taken when measuring starts (Scene::observe) and after each
/// `every`, for each quantity its own.
class Samplers {
 public:
  /// The simulation is at the beginning of its run, or where a resumed run goes on. Throws InputError if something that is
  /// asked for has no meaning in the scene; names and reasons are those of the problems.
  Samplers(const Scene& scene, const Simulation& simulation);

  [[nodiscard]] bool any() const noexcept { return !samplers_.empty(); }

  /// None: nothing is asked for.
  [[nodiscard]] std::optional<Appointment> next() const;

  /// The simulation has come to `next()`.
  void look(const Simulation& simulation);

  /// NaN for what was not sampled often enough.
  [[nodiscard]] Estimates estimates() const;

  /// One for each quantity; see `observed_tables`.
  [[nodiscard]] std::vector<Table> tables() const;

 private:
  using AnySampler = std::variant<RadialDistribution, MeanSquaredDisplacement, VelocityAutocorrelation,
                                  AngleAutocorrelation>;
  struct Timed {
    AnySampler sampler;
    double every;            // [time]
    std::int64_t taken = 0;  // samples
  };

  [[nodiscard]] double due(const Timed& t) const { return *began_ + static_cast<double>(t.taken) * t.every; }

  [[nodiscard]] double first_due() const;

  std::vector<Timed> samplers_;
  std::optional<std::int64_t> after_events_;
  double after_ = 0.0;  // [time]
  std::optional<double> began_;
  Snapshot balls_;
};

/// Runs to the end that `run` gives, and looks on the way.
Stop run_sampled(Simulation& simulation, const RunSpec& run, Samplers& samplers, const CollisionSink& sink = {});

/// The names of the tables that a scene asks for, in the order of Samplers::tables.
[[nodiscard]] std::vector<std::string> observed_tables(const ObserveSpec& observe);

}  // namespace carom
