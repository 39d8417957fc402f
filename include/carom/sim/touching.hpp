#pragma once
// Who acts together at one moment: the graph of contacts that an event belongs to.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "carom/law/impact.hpp"
#include "carom/predict/ball_ball.hpp"
#include "carom/predict/ball_wall.hpp"
#include "carom/predict/contact.hpp"
#include "carom/predict/event.hpp"
#include "carom/world/state.hpp"

namespace carom {

/// A contact at a moment, as an event then.
template <class Real, int D>
struct TouchingContact {
  Event<Real, D> event;
  bool held = false;  ///< by state alone: the two do not meet at this moment
};

/// Finds the contacts that are connected with an event through balls of finite mass. Two parties are in contact at a moment
///   if they meet then, whoever else does;
///   or if they hold a contact with each other and nothing has parted them: it was made at this moment, or they have moved
///   with one velocity ever since.
/// Both are functions of the stored states, so the graph is the same under every search and queue.
template <Motion M>
class Touching {
 public:
  using Real = typename M::Real;
  static constexpr int D = M::dimension;
  using WorldType = World<Real, D>;
  using EventType = Event<Real, D>;

  using Found = TouchingContact<Real, D>;

  /// The contacts at the time of `first`, which is one of them: in the order of events, each once.
  template <class Search>
  [[nodiscard]] const std::vector<Found>& around(const WorldType& world, const M& motion, const Search& search,
                                                     const EventType& first) {
    contacts_.clear();
    balls_.clear();
    add(first, false);
    reach(world, first.ball);
    if (first.kind == EventKind::ball_ball) reach(world, first.partner);
    for (std::size_t k = 0; k < balls_.size(); ++k) look_around(world, motion, search, balls_[k], first.time);
    std::sort(contacts_.begin(), contacts_.end(), [](const Found& a, const Found& b) {
      if (precedes(a.event, b.event)) return true;
      return !precedes(b.event, a.event) && a.held < b.held;
    });
    const auto same = [](const Found& a, const Found& b) { return !precedes(a.event, b.event); };
    contacts_.erase(std::unique(contacts_.begin(), contacts_.end(), same), contacts_.end());
    return contacts_;
  }

 private:
  /// Through a ball of infinite mass nothing is passed on.
  void reach(const WorldType& world, std::uint32_t i) {
    if (detail::infinite(world.body_mass(i))) return;
    if (std::find(balls_.begin(), balls_.end(), i) == balls_.end()) balls_.push_back(i);
  }
  void add(const EventType& e, bool held) { contacts_.push_back({e, held}); }

  template <class Search>
  void look_around(const WorldType& world, const M& motion, const Search& search, std::uint32_t i, const Time<Real>& now) {
    search.for_each_wall(world, i, [&](const auto& shape, const Image<D>& image) {
      const EventType e = predict_wall(motion, world, i, shape, image);
      if (e.kind == EventKind::ball_wall && e.time == now) add(e, false);
    });
    search.for_each_partner(world, i, [&](std::uint32_t j, const Image<D>& image) {
      EventType e;
      consider_meeting(motion, world, i, j, image, e);
      if (e.kind == EventKind::none || e.time != now) return;
      add(e, false);
      reach(world, j);
    });
    if (!world.balls[i].in_contact) return;
    for (const Contact<D>& c : world.details[i].contacts) {
      if (c.party == Party::wall) {
        hold_wall(world, i, c, now);
      } else if (touch_of_pair(world, i, c.partner, c.image) != Touch::none && keeps(world, i, c.partner, now)) {
        EventType e = event_of(world, i, now);
        e.kind = EventKind::ball_ball;
        e.ball = std::min(i, c.partner);
        e.partner = std::max(i, c.partner);
        e.image = i < c.partner ? c.image : -c.image;
        add(e, true);
        reach(world, c.partner);
      }
    }
  }

  [[nodiscard]] static EventType event_of(const WorldType& world, std::uint32_t i, const Time<Real>& now) {
    EventType e;
    e.time = now;
    e.ball = i;
    e.stamp = world.balls[i].stamp;
    return e;
  }

  [[nodiscard]] static bool keeps(const WorldType& world, std::uint32_t i, std::uint32_t j, const Time<Real>& now) {
    const Ball<Real, D>&a = world.balls[i], &b = world.balls[j];
    return a.time == now || (a.velocity == b.velocity && a.fixed == b.fixed);
  }

  /// The velocity keeps the ball on a wall that it touches.
  [[nodiscard]] static bool slides_along(const Ball<Real, D>& ball, const Face<Real, D>& face) {
    return ball.velocity[face.axis] == 0;
  }
  [[nodiscard]] static bool slides_along(const Ball<Real, D>& ball, const Plane<Real, D>& plane) {
    return dot<Real, D>(plane.direction, ball.velocity - plane.velocity) == 0;
  }
  template <class Shape>
  [[nodiscard]] static bool slides_along(const Ball<Real, D>& ball, const Shape& shape) {
    return ball.velocity == shape.velocity;
  }

  void hold_wall(const WorldType& world, std::uint32_t i, const Contact<D>& c, const Time<Real>& now) {
    const Ball<Real, D>& ball = world.balls[i];
    world.walls.with(c.partner, c.feature, [&](const auto& shape) {
      if (ball.time != now && swing_of(world.walls, shape) != nullptr) return;
      if (ball.time != now && !(M::circular ? ball.velocity == Vec<Real, D>::Zero() : slides_along(ball, shape))) return;
      EventType e = event_of(world, i, now);
      e.kind = EventKind::ball_wall;
      e.partner = c.partner;
      e.feature = c.feature;
      e.image = c.image;
      e.side = c.side;
      add(e, true);
    });
  }

  std::vector<Found> contacts_;
  std::vector<std::uint32_t> balls_;
};

}  // namespace carom
