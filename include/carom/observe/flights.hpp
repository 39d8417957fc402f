#pragma once
// Follows every ball from collision to collision: from the records alone, without looking at the simulation.

#include <vector>

#include "carom/core/clock.hpp"
#include "carom/observe/flight.hpp"
#include "carom/observe/subject.hpp"
#include "carom/sim/simulation.hpp"

namespace carom {

/// Keeps the subject's places, velocities and masses up to date, and hands out the flights that end. Laws that join balls to bodies
/// of several change velocities that no record tells of: then flights are wrong.
class Flights {
 public:
  /// From the subject's moment on.
  explicit Flights(Subject subject)
      : subject_(std::move(subject)), from_(subject_.mass.size(), subject_.moment), measured_from_(subject_.moment) {}

  [[nodiscard]] const Subject& subject() const noexcept { return subject_; }

  /// Measuring begins: flights under way are cut there, and the subject's places and velocities are those at `t`.
  void begin(const Time<double>& t) {
    measured_from_ = subject_.moment = t;
    for (std::uint32_t i = 0; i < from_.size(); ++i) {
      const Course now = course_at(i, t);
      subject_.position[i] = now.position;
      subject_.velocity[i] = now.velocity;
      from_[i] = t;
    }
  }

  /// The collision's parties end their flights: f(flight) for each that moves freely.
  template <class F>
  void end_by(const Collision& c, const Time<double>& now, F&& f) const {
    if (subject_.moves_freely(c.ball.number)) f(flight(c.ball.number, now, place(c.ball), true));
    if (c.kind == EventKind::ball_ball && subject_.moves_freely(c.partner.number))
      f(flight(c.partner.number, now, place(c.partner), true));
  }

  /// The ball has left through an opening, which no collision tells: f(flight) for what was measured of its last one.
  template <class F>
  void leave(std::uint32_t ball, const Time<double>& when, F&& f) {
    if (!subject_.moves_freely(ball)) return;
    if (when > from_[ball]) f(flight(ball, when, course_at(ball, when).position, false));
    subject_.mass[ball] = 0;
    --subject_.free;
  }

  /// Measuring ends: f(flight) for every ball that moves freely.
  template <class F>
  void end(const Time<double>& now, F&& f) const {
    for (std::uint32_t i = 0; i < from_.size(); ++i)
      if (subject_.moves_freely(i)) f(flight(i, now, course_at(i, now).position, false));
  }

  /// The parties go on as the collision has left them.
  void go_on(const Collision& c, const Time<double>& now);

 private:
  [[nodiscard]] double elapsed_time(const Time<double>& a, const Time<double>& b) const {
    return elapsed(a, b) * subject_.epoch_length;
  }
  struct Course {
    Triple position, velocity;
  };
  [[nodiscard]] Course course_at(std::uint32_t i, const Time<double>& t) const;
  [[nodiscard]] Triple place(const Collision::Party& party) const;
  [[nodiscard]] Flight flight(std::uint32_t i, const Time<double>& now, const Triple& to, bool hit) const;

  Subject subject_;
  std::vector<Time<double>> from_;  // by ball: when it took on subject_.velocity
  Time<double> measured_from_;
};

}  // namespace carom
