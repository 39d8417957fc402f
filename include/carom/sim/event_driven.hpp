#pragma once
// The event-driven integrator: predict, take the first, advance its parties alone, resolve, predict anew.
//
// The algorithm is that of Alder and Wainwright [AlderWainwright1959] with a state, a clock and one live event for each
// ball [Lubachevsky1991]: a ball that takes part in no event is not touched.

#include <atomic>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "carom/predict/ball_ball.hpp"
#include "carom/predict/ball_wall.hpp"
#include "carom/predict/growing.hpp"
#include "carom/queue/event_queue.hpp"
#include "carom/search/neighbour_search.hpp"
#include "carom/sim/books.hpp"
#include "carom/sim/collapse_watch.hpp"
#include "carom/sim/collision.hpp"
#include "carom/sim/instant_watch.hpp"
#include "carom/sim/parted.hpp"
#include "carom/sim/rescale.hpp"
#include "carom/sim/record.hpp"
#include "carom/sim/stop.hpp"
#include "carom/sim/touching.hpp"

namespace carom {

template <Motion M, class Search, class Queue>
requires NeighbourSearch<Search, M> && EventQueue<Queue>
class EventDriven {
 public:
  using Real = typename M::Real;
  static constexpr int D = M::dimension;
  using WorldType = World<Real, D>;
  using EventType = Event<Real, D>;

  EventDriven(WorldType& world, const M& motion, Search search = Search())
      : world_(world), motion_(motion), now_(world.start), search_(std::move(search)) {
    collider_.reset(world_, motion_);
    predict_all(now_);
  }

  /// Carries out events until the next one lies after `until`, `collisions` have happened, or nothing more will. `sink` is
  /// given a record of each collision, if it wants them.
  template <class Sink>
  Stop advance(const Time<Real>& until, std::int64_t collisions, Sink&& sink,
               const std::atomic<bool>* interrupt = nullptr) {
    const std::int64_t goal = collisions < std::numeric_limits<std::int64_t>::max() - counts().collisions()
                                  ? counts().collisions() + collisions
                                  : std::numeric_limits<std::int64_t>::max();
    while (true) {
      if (counts().collisions() >= goal) return Stop::events;
      if (interrupt != nullptr && interrupt->load(std::memory_order_relaxed)) return Stop::interrupted;
      const EventType event = queue_.top();
      if constexpr (GrowingMotion<M>) {
        if (const Time<Real>& due = growth_due(); due < event.time) {
          if (due > until) return Stop::until;
          if (due == world_.growth.packed) return Stop::packing;
          if (due == world_.growth.full) return no_space(due);
          predict_all(due);
          continue;
        }
      }
      if (event.kind == EventKind::none) return Stop::no_events_left;
      if (event.time > until) return Stop::until;
      if (event.kind == EventKind::bookkeeping) {
        cross(event);
        if (++quiet_ % patience() == 0 && nothing_left(event.time)) return Stop::no_events_left;
      } else if (stale(event)) {
        ++collider_.exactness.repredicted;
        predict(queue_.top_slot());
      } else {
        if (event.time < now_) ++collider_.exactness.clamped;
        const bool instant = event.time == now_ && world_.law == LawKind::restitution;
        now_ = event.time;
        quiet_ = 0;
        if (instant) {
          instant_.before(world_, event);
        } else {
          instant_.begin();
        }
        Verdict verdict = collide(event, sink);
        if constexpr (requires { sink.moved(collider_.moved()); }) sink.moved(collider_.moved());
        predict_moved();
        if (instant && verdict == Verdict::go_on && instant_.repeats(world_, event)) verdict = no_room();
        if (verdict == Verdict::collapse) return Stop::collapse;
        if (verdict == Verdict::non_finite) return Stop::non_finite;
        if constexpr (GrowingMotion<M>)
          if (const Stop stop = after_growth(sink); stop != Stop::events) return stop;
      }
    }
  }

  /// Goes on from a world, books and counts that were put back as they were at `now`, the moment of the last collision.
  void resume(const Time<Real>& now) {
    now_ = crossed_ = now;
    quiet_ = 0;
    instant_.begin();
    predict_all(now_);
  }

  /// Turns every velocity round at the moment t, not before the last collision, and the magnetic field.
  void reverse(const Time<Real>& t) {
    std::vector<std::uint32_t> written;
    std::vector<bool> done(world_.balls.size(), false);
    for (std::uint32_t i = 0; i < world_.balls.size(); ++i) {
      if (!world_.balls[i].alive || world_.balls[i].fixed || done[i]) continue;
      written.clear();
      write_motion(world_, motion_, i, position_at(motion_, world_, i, t),
                   Vec<Real, D>(-velocity_at(motion_, world_, i, t)), t, written);
      for (const std::uint32_t k : written) done[k] = true;
      if constexpr (M::can_rest)
        if (world_.balls[i].held != 0) release(world_, i);
    }
    if constexpr (M::circular) motion_.reverse();
    resume(t);
  }

  /// Moment of the last event, or of the start.
  [[nodiscard]] const Time<Real>& now() const noexcept { return now_; }
  [[nodiscard]] const M& motion() const noexcept { return motion_; }
  [[nodiscard]] const EventCounts& counts() const noexcept { return collider_.counts; }
  [[nodiscard]] const Exactness<Real>& exactness() const noexcept { return collider_.exactness; }
  [[nodiscard]] const EnergyBooks<Real>& books() const noexcept { return collider_.books; }
  [[nodiscard]] const Collider<M>& collider() const noexcept { return collider_; }
  [[nodiscard]] Collider<M>& collider() noexcept { return collider_; }

 private:
  /// The search starts anew on the world as it is at t; contact times do not depend on when they are found.
  void predict_all(const Time<Real>& t) {
    const std::uint32_t n = static_cast<std::uint32_t>(world_.balls.size());
    queue_.reset(n);
    next_.assign(n, EventType{});
    search_.reset(world_, motion_, t);
    if (t > crossed_) crossed_ = t;
    if constexpr (GrowingMotion<M> && requires { search_.outgrown(world_); }) outgrown_ = search_.outgrown(world_);
    for (std::uint32_t i = 0; i < n; ++i) predict(i);
  }

  // --- growth ---

  /// The first of: packed, full, the cells too small.
  [[nodiscard]] const Time<Real>& growth_due() const {
    const Time<Real>&packed = world_.growth.packed, &full = world_.growth.full;
    const Time<Real>& first = full < packed ? full : packed;
    return outgrown_ < first ? outgrown_ : first;
  }

  Stop no_space(const Time<Real>& t) {
    now_ = t;
    collider_.reason = "a ball has grown until it fills its space";
    collider_.reason_balls = {};
    for (std::uint32_t i = 0; i < world_.balls.size(); ++i)
      if (collider_.reason_balls.empty() || radius_at(world_, i, t) > radius_at(world_, collider_.reason_balls[0], t))
        collider_.reason_balls = {i};
    return Stop::collapse;
  }

  /// What is due after a collision: a block of the pressure, then a rescaling. `events`: go on.
  template <class Sink>
  Stop after_growth(Sink&& sink) {
    Stop stop = Stop::events;
    if (collider_.growth.count(world_, counts(), books(), now_)) {
      const Real& pressure = collider_.growth.pressure;
      if (world_.growth.pressure > 0 && pressure >= world_.growth.pressure) {
        stop = Stop::pressure;
      } else if (pressure == infinity<Real>()) {
        collider_.reason = "the balls are jammed: no time goes by between their impacts";
        collider_.reason_balls.assign(collider_.moved().begin(), collider_.moved().end());
        stop = Stop::collapse;
      }
    }
    if (world_.growth.rescale_every > 0 && counts().collisions() % world_.growth.rescale_every == 0) {
      const auto written = rescale(world_, motion_, collider_, now_);
      if constexpr (requires { sink.moved(collider_.moved()); }) sink.moved(std::span<const std::uint32_t>(written));
      predict_all(now_);
    }
    return stop;
  }

  /// Law "symmetric": together with all contacts that act at the same moment, if there are any.
  template <class Sink>
  Verdict collide(const EventType& event, Sink&& sink) {
    if (world_.simultaneous == Simultaneous::symmetric && event.kind != EventKind::motion_change) {
      const auto& found = touching_.around(world_, motion_, search_, event);
      if (found.size() > 1) return collider_.collide_together(world_, motion_, found, sink);
    }
    return collider_.collide(world_, motion_, event, sink);
  }

  void predict_moved() {
    for (const std::uint32_t i : collider_.moved()) search_.moved(world_, motion_, i);
    for (const std::uint32_t i : collider_.moved())
      if (!search_.fits(world_, i, Real(2 * world_.balls[i].radius))) return predict_all(now_);
    for (const std::uint32_t i : collider_.moved()) predict(i);
  }

  /// The first of all collisions that ball i may have before its next bookkeeping, and of that, becomes its event.
  void predict(std::uint32_t i) {
    EventType& first = next_[i];
    first = EventType{};
    if (world_.balls[i].alive) {
      consider_walls(i);
      search_.for_each_partner(world_, i, [&](std::uint32_t j, const Image<D>& image) {
        consider_meeting(motion_, world_, i, j, image, first);
      });
    }
    enqueue(i);
  }

  void consider_walls(std::uint32_t i) {
    EventType& first = next_[i];
    search_.for_each_wall(world_, i, [&](const auto& shape, const Image<D>& image) {
      const EventType e = predict_wall(motion_, world_, i, shape, image);
      if (e.kind != EventKind::none && precedes(e, first)) first = e;
    });
  }

  /// Ball e.ball passes into another cell: only the partners that this brings within reach are new, and in a periodic space
  /// the walls.
  void cross(const EventType& e) {
    search_.cross(e);
    if (world_.space.periodic()) consider_walls(e.ball);
    search_.for_each_new_partner(world_, e, [&](std::uint32_t j, const Image<D>& image) {
      consider_meeting(motion_, world_, e.ball, j, image, next_[e.ball]);
    });
    crossed_ = e.time;
    enqueue(e.ball);
  }

  void enqueue(std::uint32_t i) {
    const EventType passage = search_.next_bookkeeping(world_, motion_, i, crossed_ > now_ ? crossed_ : now_);
    queue_.assign(i, passage.kind != EventKind::none && precedes(passage, next_[i]) ? passage : next_[i]);
  }

  Verdict no_room() {
    collider_.reason = "balls without room to move hit each other for ever, and time does not go on";
    collider_.reason_balls = instant_.balls();
    return Verdict::collapse;
  }

  /// In a periodic space balls that never meet cross its cells for ever. After this many passages without a collision it is
  /// asked whether there is anything to wait for: all pairs are looked at, so that many passages cost more.
  [[nodiscard]] std::int64_t patience() const { return 1024 + static_cast<std::int64_t>(next_.size() * next_.size()); }

  [[nodiscard]] bool nothing_left(const Time<Real>& t) const {
    if (!world_.space.periodic() || GrowingMotion<M>) return false;
    for (const EventType& e : next_)
      if (e.kind != EventKind::none) return false;
    return parted(motion_, world_, now_, t);
  }

  /// The motion of a party has changed since the prediction.
  [[nodiscard]] bool stale(const EventType& e) const {
    if (world_.balls[e.ball].stamp != e.stamp) return true;
    return e.kind == EventKind::ball_ball && world_.balls[e.partner].stamp != e.partner_stamp;
  }

  WorldType& world_;
  M motion_;
  Time<Real> now_;             // of the last collision
  Time<Real> crossed_ = now_;  // of the last bookkeeping
  Time<Real> outgrown_ = Time<Real>::never();  // when growing balls have outgrown the search
  std::int64_t quiet_ = 0;     // bookkeeping events since then
  Collider<M> collider_;
  InstantWatch<Real, D> instant_;
  Touching<M> touching_;
  Search search_;
  Queue queue_;
  std::vector<EventType> next_;  // by ball: its first collision, stale or not: never later than the true one
};

}  // namespace carom
