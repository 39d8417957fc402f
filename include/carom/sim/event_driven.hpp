#pragma once
// The event-driven integrator: predict, take the first, advance its parties alone, resolve, predict anew.
//
// The algorithm is that of Alder and Wainwright [AlderWainwright1959] with a state, a clock and one live event for each ball
// [Lubachevsky1991]: a ball that takes part in no event is not touched.

#include <atomic>
#include <cstdint>
#include <limits>

#include "carom/predict/ball_ball.hpp"
#include "carom/predict/ball_wall.hpp"
#include "carom/queue/event_queue.hpp"
#include "carom/search/neighbour_search.hpp"
#include "carom/sim/books.hpp"
#include "carom/sim/collapse_watch.hpp"
#include "carom/sim/collision.hpp"
#include "carom/sim/record.hpp"
#include "carom/sim/stop.hpp"

namespace carom {

template <Motion M, class Search, class Queue>
  requires NeighbourSearch<Search, M> && EventQueue<Queue>
class EventDriven {
 public:
  using Real = typename M::Real;
  static constexpr int D = M::dimension;
  using WorldType = World<Real, D>;
  using EventType = Event<Real, D>;

  EventDriven(WorldType& world, const M& motion) : world_(world), motion_(motion), now_(world.start) {
    collider_.reset(world_);
    predict_all();
  }

  /// Carries out events until the next one lies after `until`, `collisions` have happened, or nothing more will. `sink` is
  /// given a record of each collision, if it wants them.
  template <class Sink>
  Stop advance(const Time<Real>& until, std::int64_t collisions, Sink&& sink, const std::atomic<bool>* interrupt = nullptr) {
    const std::int64_t goal = collisions < std::numeric_limits<std::int64_t>::max() - counts().collisions()
                                  ? counts().collisions() + collisions
                                  : std::numeric_limits<std::int64_t>::max();
    while (true) {
      if (counts().collisions() >= goal) return Stop::events;
      if (interrupt != nullptr && interrupt->load(std::memory_order_relaxed)) return Stop::interrupted;
      const EventType event = queue_.top();
      if (event.kind == EventKind::none) return Stop::no_events_left;
      if (event.time > until) return Stop::until;
      if (event.kind == EventKind::bookkeeping) {
        search_.cross(world_, motion_, event);
        predict(event.ball);
      } else if (stale(event)) {
        ++collider_.exactness.repredicted;
        predict(queue_.top_slot());
      } else {
        if (event.time < now_) ++collider_.exactness.clamped;
        now_ = event.time;
        const Verdict verdict = collider_.collide(world_, motion_, event, sink);
        for (const std::uint32_t i : collider_.moved()) search_.moved(world_, motion_, i);
        for (const std::uint32_t i : collider_.moved()) predict(i);
        if (verdict == Verdict::collapse) return Stop::collapse;
        if (verdict == Verdict::non_finite) return Stop::non_finite;
      }
    }
  }

  /// Moment of the last event, or of the start.
  [[nodiscard]] const Time<Real>& now() const noexcept { return now_; }
  [[nodiscard]] const M& motion() const noexcept { return motion_; }
  [[nodiscard]] const EventCounts& counts() const noexcept { return collider_.counts; }
  [[nodiscard]] const Exactness<Real>& exactness() const noexcept { return collider_.exactness; }
  [[nodiscard]] const EnergyBooks<Real>& books() const noexcept { return collider_.books; }
  [[nodiscard]] const Collider<M>& collider() const noexcept { return collider_; }

 private:
  void predict_all() {
    const std::uint32_t n = static_cast<std::uint32_t>(world_.balls.size());
    queue_.reset(n);
    search_.reset(world_, motion_);
    for (std::uint32_t i = 0; i < n; ++i) predict(i);
  }

  /// The first of all that may happen to ball i becomes its event.
  void predict(std::uint32_t i) {
    EventType first;
    if (world_.balls[i].alive) {
      const auto consider = [&first](const EventType& e) {
        if (e.kind != EventKind::none && precedes(e, first)) first = e;
      };
      world_.walls.for_each([&](const auto& shape) { consider(predict_wall(motion_, world_, i, shape)); });
      search_.for_each_partner(world_, i, [&](std::uint32_t j, const Image<D>& image) {
        consider(predict_meeting(motion_, world_, i, j, image));
      });
      consider(search_.next_bookkeeping(world_, motion_, i));
    }
    queue_.assign(i, first);
  }

  /// The motion of a party has changed since the prediction.
  [[nodiscard]] bool stale(const EventType& e) const {
    if (world_.balls[e.ball].stamp != e.stamp) return true;
    return e.kind == EventKind::ball_ball && world_.balls[e.partner].stamp != e.partner_stamp;
  }

  WorldType& world_;
  M motion_;
  Time<Real> now_;
  Collider<M> collider_;
  Search search_;
  Queue queue_;
};

}  // namespace carom
