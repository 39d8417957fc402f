#pragma once
// The log of a run from which it can be replayed exactly: events, and every change of motion, as columns of bytes.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "carom/core/double_double.hpp"
#include "carom/scene/scene.hpp"
#include "carom/sim/simulation.hpp"

namespace carom {

/// Collects columns and hands them on in chunks. A chunk is, in little-endian order and without padding:
///   u32  magic 0x4c505243, dimension D, events E, changes C, flags, 0, 0, 0
///   f64  time[E], impulse[E], position[C D] (wrapped), velocity[C D] (after it),
///        acceleration[C D] if flags & 1, radius[C] and mass[C] if flags & 2 (radius NaN: the ball has left)
///   f32  time_low[E], gap[E], energy[E], dissipated[E], balance[E], normal[E D]
///   u32  ball[E], partner[E], feature[E] (i32), changes_end[E], change_ball[C]
///   u8   kind[E] (0 two balls, 1 ball and wall, 2 other), tie[E]
/// The moment of an event is time + time_low. Event e made the changes from changes_end[e - 1] (0 for the first) to
/// changes_end[e]; until its next change a ball is at x + v s + a s^2 / 2, s after it, or on the circle of the magnetic field
/// that the scene tells. energy, dissipated and balance are
/// those after the event: kinetic + potential of the balls of finite mass, the sum of what was dissipated, and
/// energy + dissipated - initial energy - injected; NaN but for the last event of an instant.
class ReplayLog {
 public:
  using ChunkSink = std::function<void(std::string)>;

  /// `simulation` is at the start of `scene`; it must not run on once the log is gone.
  ReplayLog(const Scene& scene, Simulation& simulation, ChunkSink sink);
  ReplayLog(const ReplayLog&) = delete;
  ReplayLog& operator=(const ReplayLog&) = delete;

  void add(const Collision& c);

  /// Hands on the events since the last chunk, if there are any. Full chunks are handed on by themselves.
  void flush();

  [[nodiscard]] std::int64_t events() const noexcept { return events_; }
  [[nodiscard]] double initial_energy() const noexcept { return initial_.hi; }

 private:
  static constexpr std::size_t events_in_chunk = 65536;

  struct Columns {
    std::vector<double> time, impulse, position, velocity, acceleration, radius, mass;
    std::vector<float> time_low, gap, energy, dissipated, balance, normal;
    std::vector<std::uint32_t> ball, partner, changes_end, change_ball;
    std::vector<std::int32_t> feature;
    std::vector<std::uint8_t> kind, tie;
  };

  void change(const MotionChange& m);
  void begin_event(double time, std::int64_t epoch, double offset);
  void change_of(const Collision::Party& party, const Collision& c);
  void account(const MotionChange& m);
  void note_energy();

  ChunkSink sink_;
  int dimension_;
  double epoch_length_;
  std::vector<double> acceleration_, period_;
  bool told_;                            // of changes; else collisions tell all
  std::vector<double> mass_, radius_;    // by ball
  std::vector<DoubleDouble> energy_of_;  // by ball, at its last change
  DoubleDouble energy_, initial_, dissipated_, injected_;
  std::int64_t events_ = 0;
  std::int64_t last_epoch_ = 0;
  double last_offset_ = -1.0;
  Columns columns_;
};

}  // namespace carom
