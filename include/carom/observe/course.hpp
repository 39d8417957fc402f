#pragma once
// The course of an exact run: who met whom, and where every ball was at any moment of it.

#include <cstdint>
#include <vector>

#include "carom/observe/meeting.hpp"
#include "carom/observe/subject.hpp"
#include "carom/scene/scene.hpp"
#include "carom/sim/simulation.hpp"

namespace carom {

/// A ball at a moment.
struct Place {
  Triple position{};  ///< [length] unwrapped
  Triple velocity{};  ///< [length/time]
};

/// Filled collision by collision, in the user's units. Some 200 bytes a collision.
class Course {
 public:
  /// `simulation` is at the start of `scene`. Its law must be restitution: balls that stay together have no course of their
  /// own.
  Course(const Scene& scene, const Simulation& simulation);

  void add(const Collision& c);

  [[nodiscard]] const Meetings& meetings() const noexcept { return meetings_; }
  [[nodiscard]] std::uint32_t balls() const noexcept { return static_cast<std::uint32_t>(paths_.size()); }
  [[nodiscard]] const Subject& subject() const noexcept { return subject_; }  ///< at the start

  /// Ball `ball` at the time t >= start, if no collision comes after those that were added: x + v s + g s^2 / 2 from its
  /// last one. At a collision: after it.
  [[nodiscard]] Place at(std::uint32_t ball, double t) const;

  /// Collisions neither dissipated nor injected energy: it is that of the start at all times.
  [[nodiscard]] bool keeps_energy() const noexcept { return keeps_energy_; }
  /// Nothing in the scene changes the sum of the momenta.
  [[nodiscard]] bool keeps_momentum() const {
    return subject_.space != SpaceKind::box && !subject_.has_obstacles() && !subject_.accelerated();
  }

  /// Number of meetings up to and including time t.
  [[nodiscard]] std::int64_t meetings_until(double t) const;

  /// [length] The longest edge of the smallest upright box that holds every collision and every start.
  [[nodiscard]] double extent() const;

 private:
  struct Leg {
    double time;
    Triple position, velocity;
  };

  void add(const Collision::Party& party, double time);

  Subject subject_;
  Meetings meetings_;
  std::vector<std::vector<Leg>> paths_;  // by ball
  std::vector<bool> fixed_;
  bool keeps_energy_ = true;
};

}  // namespace carom
