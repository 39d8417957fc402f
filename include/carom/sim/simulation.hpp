#pragma once
// A scene, running: the composition that it needs, chosen from the compiled ones, behind one type.

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "carom/core/precision.hpp"
#include "carom/predict/event.hpp"
#include "carom/scene/scene.hpp"
#include "carom/sim/audit.hpp"
#include "carom/sim/summary.hpp"

namespace carom {

/// All digits of a collision's numbers, as text, where the run is not in double.
struct CollisionDigits {
  struct Party {
    std::array<std::string, 3> position, velocity;  ///< after it
  };
  std::string time, offset;
  Party ball, partner;
  std::string impulse;
};

/// A collision in the user's units; components beyond the dimension are 0.
struct Collision {
  struct Party {
    std::uint32_t number = 0;  ///< of the ball, or of the wall
    std::array<double, 3> position{};
    std::array<std::int64_t, 3> image{};
    std::array<double, 3> velocity_before{}, velocity_after{};
  };
  double time = 0.0;  ///< [time] rounded; epoch and offset hold all of it
  std::int64_t epoch = 0;
  double offset = 0.0;  ///< [time] since the epoch began
  EventKind kind = EventKind::none;
  Party ball, partner;
  std::int32_t feature = 0;  ///< of the wall
  std::array<double, 3> normal{}, point{};
  double impulse = 0.0, gap = 0.0, restitution = 1.0, dissipated = 0.0, injected = 0.0;
  double curvature = 0.0;  ///< [1/length] of the wall where it was hit; > 0: convex towards the ball, < 0: concave, 0: flat
  double arclength = 0.0;  ///< [length] along the wall's feature from its beginning to where it was hit
  bool tie = false;
  const CollisionDigits* digits = nullptr;  ///< while the sink is called; none in double
};

/// A ball as measurements over all balls see it: in doubles and without allocation.
struct Glimpse {
  std::array<double, 3> position{};  ///< [length] not wrapped
  std::array<double, 3> velocity{};  ///< [length/time]
  double radius = 0.0;               ///< [length]
  double mass = 1.0;                 ///< [mass]
};

using CollisionSink = std::function<void(const Collision&)>;

/// How a ball goes on after an event that changed its motion, in the user's units: x + v s + a s^2 / 2 until its next
/// change, or on the circle of the scene's magnetic field. Components beyond the dimension are 0.
struct MotionChange {
  std::uint32_t ball = 0;
  double time = 0.0;  ///< [time] rounded; epoch and offset hold all of it
  std::int64_t epoch = 0;
  double offset = 0.0;                ///< [time] since the epoch began
  std::array<double, 3> position{};   ///< wrapped
  std::array<std::int64_t, 3> image{};
  std::array<double, 3> velocity{}, acceleration{};
  double radius = 0.0, mass = 1.0;
  double radius_growth = 0.0;  ///< [length/time] of the radius, from then on
  bool alive = true;           ///< false: it has left
};

using MotionSink = std::function<void(const MotionChange&)>;

/// A ball that has left through an opening, in the user's units. Components beyond the dimension are 0.
struct Departure {
  std::uint32_t ball = 0;
  double time = 0.0;                 ///< [time]
  std::array<double, 3> position{};  ///< of its centre, not wrapped
  std::array<double, 3> velocity{};
  std::uint32_t wall = 0;            ///< the opening
  std::int32_t feature = 0;
};

/// What runs a scene, and why that was chosen.
struct Composition {
  std::string motion, search, queue;
  std::vector<std::string> reasons;

  [[nodiscard]] std::string text() const;
};

class Simulation {
 public:
  /// In the arithmetic of `precision`, from the exact numbers of the scene (double: each rounded once). Throws InputError.
  explicit Simulation(const Scene& scene, const Precision& precision = {});

  /// The same scene by another queue and, where it can be borne, another search: slow, and its log must be the same bit for
  /// bit.
  [[nodiscard]] static Simulation reference(const Scene& scene);

  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// Runs to the end that the scene gives.
  Stop run(const CollisionSink& sink = {});

  /// Goes on to the moment `until` (events at it included) or through `events` more collisions, whichever comes first.
  /// Looking, sampling and stopping in between change nothing of what follows.
  Stop advance(const std::optional<Number>& until, std::optional<std::int64_t> events = std::nullopt,
               const CollisionSink& sink = {}, const std::atomic<bool>* interrupt = nullptr);

  /// From now on `sink` is told of every ball whose motion an event has changed, whether that was a collision or not, after
  /// the collision's own record. Collisions tell all of it where the law is "restitution", no ball comes to rest and no
  /// velocities are scaled back: then a simulation may tell nothing.
  void watch_motion(MotionSink sink);

  /// Takes time() back to the last event, or to the start: where a run that has no events left ends.
  void return_to_last_event();

  /// Turns every velocity, and the magnetic field, round at time(). Without dissipation and moving walls the run then goes
  /// back to its start.
  void reverse();

  [[nodiscard]] Number time() const;      ///< [time] that the run has reached
  [[nodiscard]] Summary summary() const;  ///< at time()
  [[nodiscard]] const EventCounts& counts() const;
  /// Pairs of balls whose meeting was computed since the start; none: the engine does not count them.
  [[nodiscard]] std::optional<std::int64_t> predictions() const;
  [[nodiscard]] BallState ball(std::uint32_t number) const;  ///< at time()
  [[nodiscard]] std::vector<BallState> balls() const;        ///< those that are left, at time()
  [[nodiscard]] std::uint32_t ball_count() const;            ///< with those that have left
  [[nodiscard]] bool alive(std::uint32_t number) const;      ///< false: it has left
  [[nodiscard]] Glimpse glimpse(std::uint32_t number) const; ///< at time()
  [[nodiscard]] std::vector<Departure> departures() const;   ///< up to time(), by time, then by number
  [[nodiscard]] double radius_growth(std::uint32_t number) const;  ///< [length/time]
  [[nodiscard]] std::uint32_t wall_count() const;                      ///< [[wall]]s, then the faces of the box
  [[nodiscard]] std::string wall_label(std::uint32_t wall) const;
  [[nodiscard]] int dimension() const;
  [[nodiscard]] std::array<double, 3> periods() const;  ///< [length] of a periodic space; 0 where there is none
  [[nodiscard]] double epoch_length() const;
  [[nodiscard]] const Composition& composition() const;
  /// Overlaps at time(), in the user's unit of length.
  [[nodiscard]] Audit audit(AuditBy by = AuditBy::grid) const;

  /// The whole state as bytes, from which `restore` goes on bit for bit, under any search and queue. The format is
  /// that of this version and this machine's byte order.
  [[nodiscard]] std::string state() const;
  /// Puts back a state saved by a simulation of the same scene. Throws InputError if it is damaged or of another scene or
  /// version; the simulation is then as it was.
  void restore(std::string_view state);

  /// The same without all bytes in memory at a time: `save` hands them on piece by piece, and `restore` asks for those that
  /// begin at a place, of `size` in all, and for most of them three times. What `read` throws passes through.
  void save(const std::function<void(std::string_view)>& piece) const;
  void restore(std::uint64_t size, const std::function<void(std::uint64_t at, std::span<char> to)>& read);

  class Engine;

 private:
  explicit Simulation(std::unique_ptr<Engine> engine);

  std::unique_ptr<Engine> engine_;
};

}  // namespace carom
