#pragma once
// Recognises an instant that does not end: impacts that follow each other for ever without time going on.

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "carom/predict/event.hpp"
#include "carom/world/world.hpp"

namespace carom {

/// Within one instant no ball moves, so what follows depends on the velocities, and on which contacts are spent: those that
/// the last impacts made. A ball with no room between two walls is turned to and fro; its velocities come back, and then
/// all comes back. The watch marks a state (after 64, 128, 256, ... impacts of an instant [Brent1980]) and waits until
/// every velocity is the marked one again after the same impact. When that has happened twice, after equally many impacts,
/// the impacts of the one period have been those of the other, contacts included, and there is no end. Equality is exact,
/// and elastic impacts that do come to an end, however many, never repeat a state.
template <class Real, int D>
class InstantWatch {
 public:
  using WorldType = World<Real, D>;
  using EventType = Event<Real, D>;

  /// Time has gone on.
  void begin() {
    if (count_ > 0) *this = InstantWatch{};
  }

  /// `event` is about to happen, at the instant of the one before it.
  void before(const WorldType& world, const EventType& event) {
    remember(world, event.ball);
    if (event.kind == EventKind::ball_ball) remember(world, event.partner);
  }

  /// It has happened; true if it is proven that this goes on for ever.
  [[nodiscard]] bool repeats(const WorldType& world, const EventType& event) {
    ++count_;
    compare(world, event.ball);
    if (event.kind == EventKind::ball_ball) compare(world, event.partner);
    if (different_ == 0 && marked_ > 0 && same_parties(event, last_)) {
      const std::int64_t period = count_ - marked_;
      marked_ = count_;
      if (period == period_) return true;
      period_ = period;
    } else if (count_ == next_) {
      next_ *= 2;
      marked_ = count_;
      period_ = 0;
      last_ = event;
      seen_.clear();
      different_ = 0;
    }
    return false;
  }

  /// Whose velocities go round, in order.
  [[nodiscard]] std::vector<std::uint32_t> balls() const {
    std::vector<std::uint32_t> all;
    for (const auto& [i, seen] : seen_) all.push_back(i);
    std::sort(all.begin(), all.end());
    return all;
  }

 private:
  struct Seen {
    Vec<Real, D> velocity;  // at the mark
    bool different = false;
  };

  void remember(const WorldType& world, std::uint32_t i) { seen_.try_emplace(i, Seen{world.balls[i].velocity}); }
  void compare(const WorldType& world, std::uint32_t i) {
    Seen& seen = seen_.at(i);
    const bool different = seen.velocity != world.balls[i].velocity;
    different_ += int(different) - int(seen.different);
    seen.different = different;
  }
  [[nodiscard]] static bool same_parties(const EventType& a, const EventType& b) {
    return a.kind == b.kind && a.ball == b.ball && a.partner == b.partner && a.feature == b.feature && a.image == b.image;
  }

  std::int64_t count_ = 0, next_ = 64, marked_ = 0, period_ = 0;
  EventType last_;                                // at the mark
  std::unordered_map<std::uint32_t, Seen> seen_;  // by ball: those hit since the mark
  std::int64_t different_ = 0;                    // how many of them have another velocity than at the mark
};

}  // namespace carom
