#pragma once
// How far and how long a ball flies between two collisions.

#include "carom/observe/block_sums.hpp"
#include "carom/observe/observer.hpp"

namespace carom {

/// mean_free_path [length] and mean_free_time [time]: path and time of all balls that move freely, over the number of their
/// flights that ended in a collision with anything, walls too. The flights at both ends of the measuring are counted as far
/// as they were measured; leaving them out would favour the short ones.
class FreePath {
 public:
  explicit FreePath(const Subject& subject) : sums_(subject.epoch_length) {}

  void flight(const Flight& f) {
    sums_.spread(f.begin, f.end, {f.path(), f.duration, 0});
    if (f.hit) sums_.add(f.end, {0, 0, 1});
  }
  void collision(const Collision&, double, const Subject&) {}
  void end(double t) { sums_.end(t); }
  [[nodiscard]] Estimates estimates() const {
    return {sums_.estimate("mean_free_path", [](const auto& s) { return s[0] / s[2]; }),
            sums_.estimate("mean_free_time", [](const auto& s) { return s[1] / s[2]; })};
  }

 private:
  BlockSums<3> sums_;  // path, time, hits
};

}  // namespace carom
