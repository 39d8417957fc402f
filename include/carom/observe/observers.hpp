#pragma once
// What [observe] asks for: measures while a simulation runs.

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "carom/observe/boundary_map.hpp"
#include "carom/observe/caustic.hpp"
#include "carom/observe/collision_rate.hpp"
#include "carom/observe/estimate.hpp"
#include "carom/observe/flights.hpp"
#include "carom/observe/free_path.hpp"
#include "carom/observe/lyapunov.hpp"
#include "carom/observe/phase_space_portion.hpp"
#include "carom/observe/poincare.hpp"
#include "carom/observe/rotation_number.hpp"
#include "carom/observe/row_outlet.hpp"
#include "carom/observe/speed_histogram.hpp"
#include "carom/observe/virial_pressure.hpp"
#include "carom/observe/wall_pressure.hpp"
#include "carom/observe/wall_sequence.hpp"

namespace carom {

/// Usage: make it, give `sink()` to the run, call `end`, read `estimates()`. It is told of collisions and never touches the
/// simulation, so a run goes the same way with it and without. Measuring starts where Scene::observe says: after a number
/// of collisions (those of its moment that follow count), or after a time (collisions at it do not count).
class Observers {
 public:
  /// The simulation is at the beginning of its run, or where a resumed run goes on (measuring starts anew). Throws
  /// InputError if something that is asked for has no meaning in the scene; names and reasons are those of the problems.
  Observers(const Scene& scene, const Simulation& simulation);
  Observers(const Observers&) = delete;
  Observers& operator=(const Observers&) = delete;

  /// Whether anything is asked for.
  [[nodiscard]] bool any() const noexcept { return !makers_.empty(); }

  /// From now on the rows of `streamed_tables` that has this name go to `sink`; before, and without one, they are lost.
  void stream(const std::string& name, RowSink sink);

  /// Empty, so that no record is made, if nothing is asked for. Must not outlive this object.
  [[nodiscard]] CollisionSink sink();

  void collision(const Collision& c);

  /// The run has ended: measures up to the time that the simulation has reached. Once.
  void end(const Simulation& simulation);

  /// After `end`. Without a value if measuring never started.
  [[nodiscard]] Estimates estimates() const;

  /// After `end`; none: not asked for. Empty if measuring never started.
  [[nodiscard]] std::optional<std::vector<SpeedBin>> speed_table() const;

  /// After `end`: one for each of `final_tables`, in their order. Without rows if measuring never started.
  [[nodiscard]] std::vector<Table> tables() const;

 private:
  using AnyObserver = std::variant<CollisionRate, FreePath, VirialPressure, WallPressure, SpeedHistogram, Lyapunov,
                                   BoundaryMap, Poincare, RotationNumber, Caustic, PhaseSpacePortion, WallSequence>;
  using Outlets = std::map<std::string, std::unique_ptr<RowOutlet>>;  // by name of the table; observers hold on to them
  using Maker = std::function<AnyObserver(const Subject&)>;  // when measuring begins

  /// What the scene asks for, and what has no meaning in it.
  class Plan;

  Observers(const Simulation& simulation, const Scene& scene);  // with the parts of its tables

  [[nodiscard]] Time<double> moment(double t) const;
  void begin(const Time<double>& t);
  void measure(const Collision& c, const Time<double>& now);
  void tell(const Flight& flight);
  void left(std::uint32_t ball, const Time<double>& when);

  Flights flights_;
  Outlets outlets_;
  std::vector<Maker> makers_;
  std::optional<std::int64_t> after_events_;
  std::int64_t seen_;   // collisions so far
  Time<double> after_;  // no earlier than the start
  Time<double> last_;   // collision, or the start
  std::optional<Time<double>> began_;
  std::vector<AnyObserver> observers_;  // made when measuring begins
};

/// The names of the tables that Observers give at the end.
[[nodiscard]] std::vector<std::string> final_tables(const ObserveSpec& observe);

}  // namespace carom
