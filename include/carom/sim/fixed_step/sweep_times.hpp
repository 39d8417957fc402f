#pragma once
// When and how balls meet on the straight paths of a step: the closed forms of the event-driven mode, from step to step.

#include <cmath>
#include <cstdint>
#include <tuple>
#include <vector>

#include "carom/motion/free_flight.hpp"
#include "carom/predict/ball_wall.hpp"
#include "carom/predict/event.hpp"
#include "carom/sim/fixed_step/step_state.hpp"
#include "carom/sim/wall_touch.hpp"

namespace carom {

/// A contact inside a step.
template <int D>
struct SweptMeeting {
  double t = never<double>();  ///< [L] since the step began
  EventKind kind = EventKind::none;
  std::uint32_t ball = 0, partner = 0;  ///< ball_ball: ball < partner
  std::int32_t feature = 0;
  Image<D> image{};                   ///< of the partner, relative to the positions as they are stored
  std::int8_t side = 0;               ///< of a two-sided wall
  bool at_once = false;               ///< they touched or overlapped already
  int ball_met = 0, partner_met = 0;  ///< contacts that they had had in the step when this was predicted

  /// Time; walls before balls; then ball, partner, feature, image.
  [[nodiscard]] bool after(const SweptMeeting& o) const {
    return std::tie(t, kind, ball, partner, feature, image) > std::tie(o.t, o.kind, o.ball, o.partner, o.feature, o.image);
  }
};

/// What an impact did, in the world's units.
struct SweptImpact {
  double impulse, overlap;
  bool plastic;  ///< it was without restitution
};

/// Balls have times of their own within the step. As in the event-driven mode, two that have just met are not asked again
/// until one of them has met somebody else: rounding cannot make them meet twice.
template <int D>
class SweepTimes {
 public:
  using Vector = Vec<double, D>;
  using Meeting = SweptMeeting<D>;

  explicit SweepTimes(std::size_t balls) : own_(balls, 0.0), last_(balls) {}

  /// A step begins: every ball is at its beginning.
  void begin() { std::fill(own_.begin(), own_.end(), 0.0); }

  /// Forces have acted: those that had just met a wall or a fixed ball may meet it again.
  void forget(const StepState<D>& s) {
    for (std::uint32_t i = 0; i < s.size(); ++i) {
      Last& last = last_[i];
      if (last.kind == EventKind::ball_wall) last.pulled = true;
      if (last.kind == EventKind::ball_ball && s.fixed(i) != s.fixed(last.partner)) last = Last{};
    }
  }

  void fly_all(StepState<D>& s, double t) {
    for (std::uint32_t i = 0; i < s.size(); ++i) fly(s, i, t);
  }

  /// Balls i < j, from the later of their times on.
  [[nodiscard]] Meeting pair_meeting(const StepState<D>& s, std::uint32_t i, std::uint32_t j, const Image<D>& image) const {
    Meeting c;
    const double sigma = s.radius[i] + s.radius[j];
    if ((D > 1 && sigma == 0) || just_met(s, i, j, image)) return c;  // two points never meet
    const double base = std::max(own_[i], own_[j]);
    const Vector v = s.v[j] - s.v[i];
    const Vector r = Vector(s.separation(i, j, image) + s.v[j] * (base - own_[j])) - s.v[i] * (base - own_[i]);
    const double flight = flight_time(r, v, sigma);
    if (flight == never<double>()) return c;
    c.t = base + flight;
    c.kind = EventKind::ball_ball;
    c.ball = i;
    c.partner = j;
    c.image = image;
    c.at_once = flight == 0;
    return c;
  }

  /// Calls f(Meeting) for every piece of a wall that ball i will meet, if it meets nobody before.
  template <class F>
  void for_each_wall_meeting(const StepState<D>& s, std::uint32_t i, F&& f) const {
    if (s.immovable(i) || s.world.walls.empty()) return;
    Ball<double, D> ball;
    ball.position = s.x[i];
    ball.velocity = s.v[i];
    ball.radius = s.radius[i];
    ball.time = after(s.world.start, s.since_start() + own_[i]);
    s.world.walls.for_each([&](const auto& shape) {
      Meeting c = wall_meeting(s, i, ball, shape);
      if (c.t == never<double>()) return;
      c.at_once = c.t == 0;
      c.t += own_[i];
      c.kind = EventKind::ball_wall;
      c.ball = i;
      c.partner = index(shape.wall);
      c.feature = shape.feature;
      f(c);
    });
  }

  /// The meeting happens: the parties are moved there and get their impulse.
  SweptImpact meet(StepState<D>& s, const Meeting& c, double threshold) {
    fly(s, c.ball, c.t);
    return c.kind == EventKind::ball_ball ? meet_ball(s, c, threshold) : meet_wall(s, c, threshold);
  }

 private:
  using Flight = FreeFlight<double, D>;

  /// With whom a ball met last. Of a pair both must say so.
  struct Last {
    EventKind kind = EventKind::none;
    std::uint32_t partner = 0;
    std::int32_t feature = 0;
    Image<D> image{};      // that no wrapping changes
    std::int8_t side = 0;  // of a two-sided wall
    bool pulled = false;   // by a force, since then
    bool here = true;      // it has not moved since then
  };

  void fly(StepState<D>& s, std::uint32_t i, double t) {
    if (t == own_[i]) return;
    s.x[i] += s.v[i] * (t - own_[i]);
    own_[i] = t;
    last_[i].here = false;
  }

  [[nodiscard]] static double flight_time(const Vector& r, const Vector& v, double sigma) {
    if constexpr (D == 1) {
      const double side = r[0] < 0 || (r[0] == 0 && v[0] > 0) ? -1.0 : 1.0;
      return gap_time<double>(side * r[0] - sigma, side * v[0]);
    } else {
      return meet_time<double, D>(r, v, sigma);
    }
  }

  [[nodiscard]] bool just_met(const StepState<D>& s, std::uint32_t i, std::uint32_t j, const Image<D>& image) const {
    const Last &a = last_[i], &b = last_[j];
    if (a.kind != EventKind::ball_ball || b.kind != EventKind::ball_ball || a.partner != j || b.partner != i) return false;
    const Image<D> lasting = s.lasting_image(i, j, image);
    return a.image == lasting && b.image == -lasting;
  }

  /// With `t` counted from the ball's own time.
  template <class Shape>
  [[nodiscard]] Meeting wall_meeting(const StepState<D>& s, std::uint32_t i, const Ball<double, D>& ball,
                                     const Shape& shape) const {
    const Last& last = last_[i];
    const bool met =
        last.kind == EventKind::ball_wall && last.partner == index(shape.wall) && last.feature == shape.feature;
    // A straight path comes back to nothing but the inside of a circle or sphere.
    bool concave = false;
    if constexpr (std::is_same_v<Shape, Sphere<double, D>>) concave = shape.inside;
    const Touch touch = met && !last.pulled && (last.here || !concave) ? Touch::spent : Touch::none;
    Meeting c;
    if constexpr (std::is_same_v<Shape, Segment<double>>) {
      if (touch == Touch::spent) return c;
      // A force has pulled it back to the wall: if rounding has put it beyond, its side is still the one that it came from.
      Contact<2> held;
      held.side = last.side;
      const Vector at = ball.position - drift(s.world, shape, ball.time);
      const bool pressed = met && last.side * shape.height(at) - ball.radius <= 0;
      const SidedFlight<double> sided = flight_to_segment(Flight{}, s.world, ball, shape, pressed ? &held : nullptr);
      c.t = sided.flight;
      c.side = sided.side;
    } else if constexpr (is_curved<Shape>) {
      Contact<2> held;
      held.side = last.side;
      held.acted = !last.pulled;
      held.own_stamp = ball.stamp;
      const SidedFlight<double> sided = flight_to_curved(Flight{}, s.world, ball, shape, met && (last.here || last.pulled) ? &held : nullptr);
      c.t = sided.flight;
      c.side = sided.side;
    } else {
      c.t = flight_to_wall(Flight{}, s.world, ball, shape, touch);
    }
    return c;
  }

  SweptImpact meet_ball(StepState<D>& s, const Meeting& c, double threshold) {
    fly(s, c.partner, c.t);
    Vector r = s.separation(c.ball, c.partner, c.image);
    const double sigma = s.radius[c.ball] + s.radius[c.partner];
    const double overlap = c.at_once ? std::max(0.0, sigma - std::sqrt(dot<double, D>(r, r))) : 0.0;
    if constexpr (D == 1)
      r[0] = s.v[c.ball][0] > s.v[c.partner][0] ? 1.0 : -1.0;  // they approach: also where they coincide
    const Image<D> lasting = s.lasting_image(c.ball, c.partner, c.image);
    last_[c.ball] = {EventKind::ball_ball, c.partner, 0, lasting};
    last_[c.partner] = {EventKind::ball_ball, c.ball, 0, -lasting};
    const StepImpact impact = collide_balls(s, c.ball, c.partner, r, threshold);
    return {impact.impulse, overlap, impact.restitution == 0};
  }

  SweptImpact meet_wall(StepState<D>& s, const Meeting& c, double threshold) {
    SweptImpact result{};
    s.world.walls.with(c.partner, c.feature, [&](const auto& shape) {
      Vector u = Vector::Zero(), at = s.x[c.ball];
      if constexpr (requires { shape.velocity; }) {
        u = shape.velocity;
        at -= u * (s.since_start() + c.t);
      }
      const double gap = touch_at<double, D>(shape, at, s.radius[c.ball], c.side).gap;
      const StepImpact impact = collide_wall(
          s, c.ball, c.partner, normal(shape, at, Vector(s.v[c.ball] - u), s.radius[c.ball], c.side), u, threshold);
      result = {impact.impulse, c.at_once ? std::max(0.0, -gap) : 0.0, impact.restitution == 0};
    });
    last_[c.ball] = {EventKind::ball_wall, c.partner, c.feature, {}, c.side};
    return result;
  }

  /// Towards the ball, of any length. A point that meets a vertex has none: its velocity is reversed.
  template <class Shape>
  [[nodiscard]] static Vector normal(const Shape& shape, const Vector& at, const Vector& approach, double radius,
                                     std::int8_t side) {
    if constexpr (std::is_same_v<Shape, Segment<double>>) return side * shape.normal(at);
    if constexpr (std::is_same_v<Shape, Sphere<double, D>>)
      if (shape.radius == 0 && radius == 0) return -approach;
    const WallTouch<double, D> touch = touch_at<double, D>(shape, at, radius, side);
    if (touch.singular) return -approach;
    Vector n;
    for (int k = 0; k < D; ++k) n[k] = -narrow(touch.into_wall[k]);
    return n;
  }

  std::vector<double> own_;  // [L] since the step began, by ball
  std::vector<Last> last_;   // by ball
};

}  // namespace carom
