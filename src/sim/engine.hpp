#pragma once
// A composition behind one interface, in the user's units and in doubles.

#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <utility>

#include "carom/sim/simulation.hpp"
#include "carom/world/gases.hpp"
#include "carom/world/units.hpp"
#include "carom/world/world.hpp"

namespace carom {

class Simulation::Engine {
 public:
  Engine(const Scene& scene, Composition composition)
      : title(scene.title),
        dimension(scene.dimension),
        seed(scene.run.seed),
        until(scene.run.until),
        events(scene.run.events),
        composition_(std::move(composition)) {}
  virtual ~Engine() = default;
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  virtual Stop advance(const std::optional<Number>& until, std::optional<std::int64_t> events, const CollisionSink& sink,
                       const std::atomic<bool>* interrupt) = 0;
  virtual void return_to_last_event() = 0;
  virtual void reverse() = 0;
  [[nodiscard]] virtual Number time() const = 0;
  [[nodiscard]] virtual Summary summary() const = 0;
  [[nodiscard]] virtual const EventCounts& counts() const = 0;
  [[nodiscard]] virtual std::optional<std::int64_t> predictions() const { return std::nullopt; }
  [[nodiscard]] virtual std::uint32_t ball_count() const = 0;
  [[nodiscard]] virtual bool alive(std::uint32_t number) const = 0;
  [[nodiscard]] virtual BallState ball(std::uint32_t number) const = 0;
  [[nodiscard]] virtual Glimpse glimpse(std::uint32_t number) const;
  [[nodiscard]] virtual std::vector<Departure> departures() const = 0;  ///< by number
  [[nodiscard]] virtual double radius_growth(std::uint32_t) const { return 0.0; }
  [[nodiscard]] virtual std::uint32_t wall_count() const = 0;
  [[nodiscard]] virtual std::string wall_label(std::uint32_t wall) const = 0;
  [[nodiscard]] virtual Units units() const = 0;
  [[nodiscard]] virtual std::array<double, 3> periods() const = 0;
  [[nodiscard]] virtual Audit audit(AuditBy by) const = 0;
  virtual void save(const std::function<void(std::string_view)>& piece) const = 0;
  virtual void restore(std::uint64_t size, const std::function<void(std::uint64_t, std::span<char>)>& read) = 0;

  [[nodiscard]] const Composition& composition() const noexcept { return composition_; }

  std::string title;
  int dimension;
  std::uint64_t seed;
  std::optional<Number> until;
  std::optional<std::int64_t> events;
  MotionSink motion_sink;

 private:
  Composition composition_;
};

/// Up to this many balls all pairs is taken. Disks in a box at area fraction 0.3 put the crossing to cells between 8 and 16.
inline constexpr std::size_t few_balls = 12;

/// From so many balls on the integrator for many is taken where it fits.
inline constexpr std::size_t many_balls = 200;

/// Why the integrator for many balls cannot move these balls, for their user; empty if it can: lone balls in free flight between
/// walls that stand still, or in a periodic space that is wide enough for lists, law "restitution", contacts one by one.
template <int D>
[[nodiscard]] std::string swarm_obstacle(const WorldAndGases<D>& parts);
template <int D>
[[nodiscard]] bool swarm_fits(const WorldAndGases<D>& parts);
template <int D>
[[nodiscard]] std::unique_ptr<Simulation::Engine> make_swarm_engine(const Scene& scene, WorldAndGases<D> parts,
                                                                    Composition composition);

/// The compositions of one dimension.
template <int D>
[[nodiscard]] std::unique_ptr<Simulation::Engine> make_engine(const Scene& scene);

/// One composition of a dimension and motion, with another queue than make_engine takes.
template <int D>
[[nodiscard]] std::unique_ptr<Simulation::Engine> make_reference_engine(const Scene& scene);

/// The same two for scenes in which balls come to rest on flat walls.
template <int D>
[[nodiscard]] std::unique_ptr<Simulation::Engine> make_resting_engine(const Scene& scene, World<double, D> world,
                                                                      Composition composition);
template <int D>
[[nodiscard]] std::unique_ptr<Simulation::Engine> make_resting_reference(const Scene& scene, World<double, D> world);

/// The same two for scenes in a magnetic field.
[[nodiscard]] std::unique_ptr<Simulation::Engine> make_magnetic_engine(const Scene& scene, World<double, 2> world,
                                                                       Composition composition);
[[nodiscard]] std::unique_ptr<Simulation::Engine> make_magnetic_reference(const Scene& scene, World<double, 2> world);
/// The same two for scenes in which balls grow.
template <int D>
[[nodiscard]] std::unique_ptr<Simulation::Engine> make_growing_engine(const Scene& scene, World<double, D> world,
                                                                      Composition composition);
template <int D>
[[nodiscard]] std::unique_ptr<Simulation::Engine> make_growing_reference(const Scene& scene, World<double, D> world);

extern template bool swarm_fits(const WorldAndGases<2>&);
extern template bool swarm_fits(const WorldAndGases<3>&);
extern template std::string swarm_obstacle(const WorldAndGases<2>&);
extern template std::string swarm_obstacle(const WorldAndGases<3>&);
extern template std::unique_ptr<Simulation::Engine> make_swarm_engine(const Scene&, WorldAndGases<2>, Composition);
extern template std::unique_ptr<Simulation::Engine> make_swarm_engine(const Scene&, WorldAndGases<3>, Composition);

extern template std::unique_ptr<Simulation::Engine> make_reference_engine<1>(const Scene&);
extern template std::unique_ptr<Simulation::Engine> make_reference_engine<2>(const Scene&);
extern template std::unique_ptr<Simulation::Engine> make_reference_engine<3>(const Scene&);

/// The same in an arithmetic other than double: one composition of each motion.
template <int D>
[[nodiscard]] std::unique_ptr<Simulation::Engine> make_precise_engine(const Scene& scene, const Precision& precision);

extern template std::unique_ptr<Simulation::Engine> make_precise_engine<1>(const Scene&, const Precision&);
extern template std::unique_ptr<Simulation::Engine> make_precise_engine<2>(const Scene&, const Precision&);
extern template std::unique_ptr<Simulation::Engine> make_precise_engine<3>(const Scene&, const Precision&);

extern template std::unique_ptr<Simulation::Engine> make_engine<1>(const Scene&);
extern template std::unique_ptr<Simulation::Engine> make_engine<2>(const Scene&);
extern template std::unique_ptr<Simulation::Engine> make_engine<3>(const Scene&);

}  // namespace carom
