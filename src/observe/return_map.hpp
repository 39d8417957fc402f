#pragma once
// The state of the balls that move, as one vector, after a time: by the simulator itself, in any precision.

#include <array>
#include <cstdint>
#include <vector>

#include "carom/core/multi.hpp"
#include "carom/core/precision.hpp"
#include "carom/scene/scene.hpp"
#include "carom/sim/simulation.hpp"
#include "dense.hpp"

namespace carom {

/// Who met whom.
struct Encounter {
  EventKind kind = EventKind::none;
  std::uint32_t ball = 0, partner = 0;
  std::int32_t feature = 0;
  bool operator==(const Encounter&) const = default;
};

struct Turn {
  Encounter who;
  Multi time;
  Multis position, velocity;  ///< of the ball's centre, not wrapped; after it
  Multis partner_velocity;    ///< of a ball, after it
};

struct Circuit {
  Multis end;  ///< empty: the run did not come that far
  std::vector<Turn> turns;
  /// Whether each ball meets the same in the same order. What two balls do apart from each other may change places.
  [[nodiscard]] bool same_sequence(const Circuit& other) const;
};

/// To be used within a PrecisionScope<Multi> of its digits.
class ReturnMap {
 public:
  /// `digits` 0: the simulator in double. Throws InputError.
  ReturnMap(const Scene& scene, int digits);

  /// Positions of the balls that move, one after the other, then their velocities. [length], [length/time]
  [[nodiscard]] const Multis& start() const noexcept { return start_; }
  [[nodiscard]] std::size_t balls() const noexcept { return moving_.size(); }
  [[nodiscard]] std::size_t dimension() const noexcept { return dimension_; }
  [[nodiscard]] std::uint32_t index(std::size_t ball) const { return moving_[ball]; }
  [[nodiscard]] const std::vector<BallState>& states() const noexcept { return states_; }
  [[nodiscard]] Multi mass(std::size_t ball) const { return masses_[ball]; }
  [[nodiscard]] const Multis& periods() const noexcept { return periods_; }  ///< [length] 0: not periodic
  [[nodiscard]] bool accelerated() const noexcept;

  /// The circuit through `collisions` collisions, without its end.
  [[nodiscard]] Circuit through(const Multis& from, std::int64_t collisions) const;
  /// The circuit for a time; nothing is at its end if it stops before.
  [[nodiscard]] Circuit after(const Multis& from, const Multi& time) const;

  /// Rate of change of the state in flight.
  [[nodiscard]] Multis flow(const Multis& state) const;
  [[nodiscard]] Multi energy(const Multis& state) const;
  [[nodiscard]] Multis energy_gradient(const Multis& state) const;

 private:
  [[nodiscard]] Simulation simulation(const Multis& from) const;
  [[nodiscard]] CollisionSink recorder(Circuit& circuit) const;
  [[nodiscard]] Multis state(const Simulation& simulation) const;
  [[nodiscard]] std::size_t velocities() const { return moving_.size() * dimension_; }

  Scene scene_;
  Precision precision_;
  std::size_t dimension_;
  std::vector<std::uint32_t> moving_;
  Multis masses_, start_, periods_, acceleration_;
  Multi magnetic_;
  std::vector<BallState> states_;
};

[[nodiscard]] Multi multi(const Number& number);
/// All its digits.
[[nodiscard]] Number number(const Multi& x);

}  // namespace carom
