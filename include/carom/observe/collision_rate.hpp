#pragma once
// How often a ball collides.

#include <vector>

#include "carom/observe/block_sums.hpp"
#include "carom/observe/observer.hpp"

namespace carom {

/// collision_rate [1/time]: collisions per ball and time, over the balls that move freely. A collision of two such balls
/// counts for both; one with a wall, a fixed ball or a ball of infinite mass counts for the one. In a periodic gas it is
/// the inverse of the mean free time. wall_collision_rate [1/time]: of it, those with walls; their difference is the rate
/// among balls.
class CollisionRate {
 public:
  explicit CollisionRate(const Subject& subject) : sums_(subject.epoch_length), free_(subject.free) {}

  void collision(const Collision& c, double t, const Subject& subject) {
    pass(t);
    const bool wall = c.kind == EventKind::ball_wall;
    double parties = subject.moves_freely(c.ball.number) ? 1 : 0;
    if (!wall && subject.moves_freely(c.partner.number)) ++parties;
    sums_.add(t, {0, parties, wall ? parties : 0});
    if (subject.merging && !wall) --free_;
  }
  /// At the end: a ball had left at t.
  void left(double t) { departures_.push_back(t); }
  void end(double t) {
    pass(t);
    for (const double when : departures_)
      if (when < t) sums_.spread(when, t, {when - t, 0, 0});
    sums_.end(t);
  }
  [[nodiscard]] Estimates estimates() const {
    return {sums_.estimate("collision_rate", [](const auto& s) { return s[1] / s[0]; }),
            sums_.estimate("wall_collision_rate", [](const auto& s) { return s[2] / s[0]; })};
  }

 private:
  void pass(double t) {
    sums_.spread(last_, t, {static_cast<double>(free_) * (t - last_), 0, 0});
    last_ = t;
  }

  BlockSums<3> sums_;  // time of all balls; their collisions; those with walls
  std::int64_t free_;
  double last_ = 0.0;
  std::vector<double> departures_;
};

}  // namespace carom
