#pragma once
// One collision: bring the parties to the moment of contact, resolve the impact, write what has changed, keep the books.

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "carom/law/growing_impact.hpp"
#include "carom/predict/ball_wall.hpp"
#include "carom/predict/event.hpp"
#include "carom/sim/books.hpp"
#include "carom/sim/collapse_reason.hpp"
#include "carom/sim/collapse_watch.hpp"
#include "carom/sim/contact_rule.hpp"
#include "carom/sim/growth_books.hpp"
#include "carom/sim/measures.hpp"
#include "carom/sim/record.hpp"
#include "carom/sim/recording.hpp"
#include "carom/sim/rest.hpp"
#include "carom/sim/sides.hpp"
#include "carom/sim/together.hpp"
#include "carom/sim/unite.hpp"
#include "carom/sim/wall_party.hpp"
#include "carom/sim/wall_touch.hpp"
#include "carom/world/state.hpp"

namespace carom {

enum class Verdict : std::uint8_t { go_on, collapse, non_finite };

template <Motion M>
class Collider {
 public:
  using Real = typename M::Real;
  static constexpr int D = M::dimension;
  using WorldType = World<Real, D>;
  using Vector = Vec<Real, D>;

  EventCounts counts;
  Exactness<Real> exactness;
  EnergyBooks<Real> books;
  CollapseWatch<Real> watch;
  [[no_unique_address]] GrowthBooksOf<M> growth;
  std::string reason;                       ///< of a verdict other than go_on
  std::vector<std::uint32_t> reason_balls;  ///< whom it concerns

  void reset(const WorldType& world, const M& motion) {
    if constexpr (GrowingMotion<M>) growth.reset(motion, world);
    for (std::uint32_t i = 0; i < world.balls.size(); ++i) note_potential(world, i);
    if (world.restitution.any_below_one()) watch.reset(world.balls.size());
  }

  /// The balls whose stored state the last collision wrote.
  [[nodiscard]] std::span<const std::uint32_t> moved() const noexcept { return moved_; }

  template <class Sink>
  Verdict collide(WorldType& world, const M& motion, const Event<Real, D>& event, Sink&& sink) {
    moved_.clear();
    exactness.unresolved += event.unresolved;
    if (event.kind == EventKind::motion_change && world.walls.opens(event.partner)) return let_out(world, motion, event);
    if constexpr (M::can_rest)
      if (event.kind == EventKind::motion_change) return leave(world, motion, event);
    return event.kind == EventKind::ball_ball ? ball_ball(world, motion, event, sink)
                                              : ball_wall(world, motion, event, sink);
  }

  /// Carries out contacts of one moment at once (law/simultaneous.hpp): `found` are all that are connected. The motion of a
  /// ball that its contacts hold still does not change. What is dissipated and injected stands in the first record.
  template <class Sink>
  Verdict collide_together(WorldType& world, const M& motion, const std::vector<TouchingContact<Real, D>>& found,
                           Sink&& sink);

 private:
  using W = Wide<Real>;

  template <class Sink>
  Verdict ball_ball(WorldType& world, const M& motion, const Event<Real, D>& event, Sink&& sink) {
    const std::uint32_t i = event.ball, j = event.partner;
    const Time<Real>& now = event.time;
    BallDetail<Real, D>&a = world.details[i], &b = world.details[j];
    Impact<Real, D> impact;
    impact.va = velocity_at(motion, world, i, now);
    impact.vb = velocity_at(motion, world, j, now);
    impact.ma = world.body_mass(i);
    impact.mb = world.body_mass(j);
    if (detail::infinite(impact.ma) && detail::infinite(impact.mb))
      return stop(Verdict::collapse, "two infinite masses meet, and no law says what follows", {i, j});

    Vector xa = position_at(motion, world, i, now), xb = position_at(motion, world, j, now);
    for (int k = 0; k < D; ++k) {
      impact.r[k] = wide_difference<Real>(xb[k], xa[k]);
      if (world.space.periodic()) impact.r[k] = impact.r[k] + wide_product<Real>(Real(event.image[k]), world.space.edge[k]);
    }
    const Real sigma = radius_of(world, i, now) + radius_of(world, j, now);
    const Real gap = world.law == LawKind::merge ? Real(0) : note_gap(exactness, gap_of_pair<Real>(impact.r, sigma), sigma);
    if constexpr (D == 1) impact.r[0] = W(Real(side_on_line(world, i, j, event.image)));
    impact.e = restitution_of_pair(world, impact, i, j, now);

    const bool tie = is_tie(a, now, Party::ball, j, 0) || is_tie(b, now, Party::ball, i, 0);
    const Time<Real> before_a = a.last_hit, before_b = b.last_hit;
    Outcome<Real, D> outcome;
    if (world.law == LawKind::restitution) {
      outcome = resolve(impact, growth_of_pair(world, i, j));
      if constexpr (GrowingMotion<M>) growth.impact(outcome.impulse, sigma);
      const Turns<D> image_a = a.image, image_b = b.image;
      const Vector from_a = narrowed(impact.r);
      sides_.note(world, i);
      write(world, motion, i, xa, outcome.va, now);
      sides_.keep(world, i, Vector(-from_a));
      sides_.note(world, j);
      write(world, motion, j, xb, outcome.vb, now);
      sides_.keep(world, j, from_a);
      hold_pair(world, i, j, event.image, image_a, image_b);
    } else {
      outcome = unite(world, motion, event, impact, xa, xb, moved_);
    }

    ++counts.ball_ball;
    note_potential(world, i);
    note_potential(world, j);
    counts.ties += tie;
    book(books, outcome);
    remember(a, now, Party::ball, j, 0);
    remember(b, now, Party::ball, i, 0);
    if constexpr (std::remove_cvref_t<Sink>::wants_records) {
      Record<Real, D> record = record_of(event, impact, outcome, gap, tie);
      fill_party(record.ball, world, i, before_a);
      fill_party(record.partner, world, j, before_b);
      record.partner.velocity_before = impact.vb;
      record.partner.velocity_after = outcome.vb;
      record.point = world.balls[i].position - record.normal * radius_of(world, i, now);
      sink(record);
    }
    if (!finite(outcome.va) || !finite(outcome.vb))
      return stop(Verdict::non_finite, "a velocity is no longer a finite number", {i, j});
    if (world.law == LawKind::merge && !has_room(world, i, now))
      return stop(Verdict::collapse, "a merged ball grows into a wall, and no law says what follows", {i});
    if (world.law == LawKind::merge) return Verdict::go_on;
    if (world.law == LawKind::stick) return Verdict::go_on;
    if (outcome.impulse == 0 && before_a == now && before_b == now && !tie)
      return stop(Verdict::collapse,
                  impact.e < 1 || M::can_rest ? collapse_reason(world.regularise, Support::ball)
                                              : "a ball rests against another: the contact never ends",
                  {i, j});
    return watch_contact(world, impact, now, {i, j}, outcome.impulse, Support::ball);
  }

  template <class Sink>
  Verdict ball_wall(WorldType& world, const M& motion, const Event<Real, D>& event, Sink&& sink) {
    const std::uint32_t i = event.ball;
    const Time<Real>& now = event.time;
    BallDetail<Real, D>& a = world.details[i];
    Impact<Real, D> impact;
    impact.va = velocity_at(motion, world, i, now);
    impact.ma = world.body_mass(i);
    impact.mb = infinity<Real>();
    if (detail::infinite(impact.ma))
      return stop(Verdict::collapse, "a ball of infinite mass meets a wall, and no law says what follows", {i});

    Vector x = position_at(motion, world, i, now);
    const Real radius = radius_of(world, i, now);
    Real gap(0);
    Support support = Support::curve;
    with_wall(world, event.partner, event.feature, event.image, [&](const auto& shape, const auto& placed) {
      impact.vb = wall_velocity(world, shape, now);
      const Vector at = x - wall_drift(world, shape, now);
      const WallTouch<Real, D> place = touch_at<Real, D>(placed, at, radius, event.side);
      impact.r = place.into_wall;
      if (place.singular) {  // a point at a vertex is sent back
        ++exactness.singular;
        for (int k = 0; k < D; ++k) impact.r[k] = W(Real(impact.va[k] - impact.vb[k]));
      }
      gap = note_gap(exactness, place.gap, radius);
      if (flat_number(world.walls, shape) != 0) support = Support::corner;
    });

    impact.e = restitution_at_wall(world, impact, i, event.partner, support == Support::corner, now);
    Outcome<Real, D> outcome = resolve(impact, growth_of_ball(world, i));
    const bool tie = is_tie(a, now, Party::wall, event.partner, event.feature);
    const Time<Real> before = a.last_hit;
    const Turns<D> image = a.image;
    const bool again = is_last(a, Party::wall, event.partner, event.feature);
    std::uint8_t landed_on = 0;
    if constexpr (M::can_rest) {
      const std::optional<Landing<Real, D>> still = stay(world, i, x, outcome.va, now);
      landed_on = land(world, event, still ? motion.acceleration(M::phase(world.balls[i])) : world.acceleration, x, outcome,
                       impact.e);
      if (landed_on != 0 && still) return stop(Verdict::collapse, collapse_reason(world.regularise, Support::corner), {i});
    }
    sides_.note(world, i);
    write(world, motion, i, x, outcome.va, now);
    if (landed_on != 0) {
      world.balls[i].held = landed_on;
      ++counts.other;
      exactness.summed_bounces += outcome.impulse > 0;
    }
    hold_contact(world, i,
                 Contact<D>{Party::wall, event.partner, event.feature, image_since(world, i, event.image, image), event.side,
                            true, world.balls[i].stamp, 0});
    sides_.keep(world, i, Vector(-narrowed(impact.r)));
    if (landed_on != 0 && outcome.impulse == 0) {  // it lies there, and nothing hits anything
      note_potential(world, i);
      book(books, outcome);
      return Verdict::go_on;
    }

    ++counts.ball_wall;
    note_potential(world, i);
    counts.ties += tie;
    book(books, outcome);
    remember(a, now, Party::wall, event.partner, event.feature);
    if constexpr (std::remove_cvref_t<Sink>::wants_records) {
      Record<Real, D> record = record_of(event, impact, outcome, gap, tie);
      fill_party(record.ball, world, i, before);
      record.partner.number = event.partner;
      record.partner.velocity_before = record.partner.velocity_after = impact.vb;
      record.point = world.balls[i].position - record.normal * radius;
      note_place(world, event, x, record);
      sink(record);
    }
    if (!finite(outcome.va)) return stop(Verdict::non_finite, "a velocity is no longer a finite number", {i});
    if (outcome.impulse == 0 && before == now && !tie)
      return stop(Verdict::collapse,
                  impact.e < 1 || M::can_rest ? collapse_reason(world.regularise, support)
                                              : "a ball is pressed against a wall: the contact never ends",
                  {i});
    if (M::can_rest && support == Support::corner && again) return Verdict::go_on;  // bounces on one wall end in rest
    return watch_contact(world, impact, now, {i}, outcome.impulse, support);
  }

  static void note_place(const WorldType& world, const Event<Real, D>& event, const Vector& x, Record<Real, D>& record) {
    with_wall(world, event.partner, event.feature, event.image, [&](const auto& shape, const auto& placed) {
      fill_place(record, placed, Vector(x - wall_drift(world, shape, event.time)),
                 radius_of(world, event.ball, event.time), event.side);
    });
  }

  [[nodiscard]] static Real radius_of(const WorldType& world, std::uint32_t i, const Time<Real>& now) {
    if constexpr (GrowingMotion<M>) return radius_at(world, i, now);
    return world.balls[i].radius;
  }
  [[nodiscard]] static Real growth_of_ball(const WorldType& world, std::uint32_t i) {
    if constexpr (GrowingMotion<M>) return world.growth.rates[i];
    return Real(0);
  }
  [[nodiscard]] static Real growth_of_pair(const WorldType& world, std::uint32_t i, std::uint32_t j) {
    return growth_of_ball(world, i) + growth_of_ball(world, j);
  }
  /// `rate`: at which the gap shrinks by growth.
  [[nodiscard]] static Outcome<Real, D> resolve(const Impact<Real, D>& impact, const Real& rate) {
    if constexpr (GrowingMotion<M>) return resolve_growing_impact(impact, rate);
    return resolve_impact(impact);
  }

  /// Ball i goes on from x with velocity v: on the wall that it rests on, if v keeps it there.
  void write(WorldType& world, const M& motion, std::uint32_t i, Vector& x, Vector& v, const Time<Real>& now) {
    if constexpr (M::can_rest) {
      inject(books, work_at_rest(world, i, now));
      take_back(world, i, x, v, now);
      const std::optional<Landing<Real, D>> still = stay(world, i, x, v, now);
      const bool flies = world.balls[i].held != 0 && !still;
      if (still) take(*still, x, v);
      write_motion(world, motion, i, x, v, now, moved_);
      if (flies) release(world, i);
    } else {
      write_motion(world, motion, i, x, v, now, moved_);
    }
  }
  void take(const Landing<Real, D>& rest, Vector& x, Vector& v) {
    x = rest.position;
    v = rest.velocity;
    books.dissipated = books.dissipated + rest.dissipated;
    inject(books, rest.injected);
  }

  /// The number of the flat wall that ball event.ball has hit and come to rest on, or 0; `a` is its acceleration from now
  /// on.
  std::uint8_t land(const WorldType& world, const Event<Real, D>& event, const Vector& a, Vector& x,
                    Outcome<Real, D>& outcome, const Real& e) {
    std::uint8_t number = 0;
    world.walls.with(event.partner, event.feature, [&](const auto& shape) {
      using Shape = std::remove_cvref_t<decltype(shape)>;
      if constexpr (!std::is_same_v<Shape, Sphere<Real, D>> && !is_curved<Shape>) {
        const Vector n = towards_ball<Real, D>(shape, Vector(x - wall_drift(world, shape, event.time)), event.side);
        if (!comes_to_rest<Real, D>(shape, n, x, outcome.va, a, world.balls[event.ball].radius, e, event.time)) return;
        number = static_cast<std::uint8_t>(flat_number(world.walls, shape));
        const Landing<Real, D> rest = set_at_rest(world, shape, event.ball, x, outcome.va, event.time);
        x = rest.position;
        outcome.va = rest.velocity;
        outcome.dissipated = outcome.dissipated + rest.dissipated;
        outcome.injected = outcome.injected + rest.injected;
      }
    });
    return number;
  }

  /// Ball event.ball leaves through an opening, with all of its energy.
  Verdict let_out(WorldType& world, const M& motion, const Event<Real, D>& event) {
    const std::uint32_t i = event.ball;
    BallDetail<Real, D>& ball = world.details[i];
    if constexpr (M::can_rest) inject(books, work_at_rest(world, i, event.time));
    write_motion(world, motion, i, position_at(motion, world, i, event.time), velocity_at(motion, world, i, event.time),
                 event.time, moved_);
    if (!detail::infinite(ball.mass)) {
      const W energy = energy_of(world, i);
      books.injected = books.injected - energy;
    }
    world.balls[i].alive = false;
    world.balls[i].in_contact = false;
    ball.contacts.clear();
    remember(ball, event.time, Party::wall, event.partner, event.feature);
    ++counts.other;
    return Verdict::go_on;
  }

  /// Kinetic and potential, of a ball as stored.
  [[nodiscard]] static W energy_of(const WorldType& world, std::uint32_t i) {
    const Vector& v = world.balls[i].velocity;
    W energy = wide_dot<Real, D>(v, v) * W(Real(1) / 2);
    if constexpr (M::accelerated) {
      const auto x = unwrapped(world, i, world.balls[i].position);
      for (int k = 0; k < D; ++k) energy = energy - x[k] * W(world.acceleration[k]);
    }
    return W(world.details[i].mass) * energy;
  }

  /// The period that a partner stands in, seen from where ball i is stored now; it was `image` when details.image was
  /// `before`.
  [[nodiscard]] static Image<D> image_since(const WorldType& world, std::uint32_t i, Image<D> image, const Turns<D>& before) {
    for (int k = 0; k < D; ++k) image[k] -= static_cast<std::int32_t>(world.details[i].image[k] - before[k]);
    return image;
  }

  /// Ball event.ball slides off the end of the wall that it rests on.
  Verdict leave(WorldType& world, const M& motion, const Event<Real, D>& event) {
    const std::uint32_t i = event.ball;
    inject(books, work_at_rest(world, i, event.time));
    write_motion(world, motion, i, position_at(motion, world, i, event.time), velocity_at(motion, world, i, event.time),
                 event.time, moved_);
    release(world, i, true);
    note_potential(world, i);
    ++counts.other;
    return Verdict::go_on;
  }

  void note_potential(const WorldType& world, std::uint32_t i) {
    if constexpr (M::accelerated) carom::note_potential(books, world, i);
  }

  /// Both balls list the contact, with images relative to where they were stored just now.
  void hold_pair(WorldType& world, std::uint32_t i, std::uint32_t j, const Image<D>& image, const Turns<D>& image_a,
                 const Turns<D>& image_b, bool acted = true) {
    Contact<D> contact{Party::ball, j, 0, image, 0, acted, world.balls[i].stamp, world.balls[j].stamp};
    for (int k = 0; k < D; ++k)
      contact.image[k] +=
          static_cast<std::int32_t>((world.details[j].image[k] - image_b[k]) - (world.details[i].image[k] - image_a[k]));
    hold_contact(world, i, contact);
    contact.partner = i;
    std::swap(contact.own_stamp, contact.partner_stamp);
    contact.image = -contact.image;
    hold_contact(world, j, contact);
  }

  void hold_together(WorldType& world, const typename Together<Real, D>::Contact& c,
                     const std::vector<Turns<D>>& images, const Time<Real>& now, bool acted);
  static void fill_member(RecordParty<Real, D>& party, const WorldType& world,
                          const typename Together<Real, D>::Member& m, const Time<Real>& now);
  template <class Sink>
  Verdict count_together(WorldType& world, const Together<Real, D>& all, const typename Together<Real, D>::Contact& c,
                         const Outcome<Real, D>& share, Sink&& sink);

  Verdict watch_contact(const WorldType& world, const Impact<Real, D>& impact, const Time<Real>& now,
                        std::initializer_list<std::uint32_t> balls, const Real& impulse, Support support) {
    if (!watch.watching()) return Verdict::go_on;
    // Balls that rest on flat walls do so by a rule of their own, not by rounding.
    const bool may_round = !M::can_rest || support == Support::ball;
    const Real mass = impact.ma < impact.mb ? impact.ma : impact.mb;
    const Vector still = Vector::Zero();
    const typename CollapseWatch<Real>::Contact contact{
        now,
        impulse,
        may_round ? Real(mass * rounding_of_velocity(impact)) : Real(-1),
        mass * rounding_of_position(world, *balls.begin()),
        impact.e < 1,
        (detail::infinite(impact.ma) && impact.va != still) || (detail::infinite(impact.mb) && impact.vb != still)};
    bool collapse = false;
    for (const std::uint32_t i : balls) collapse = watch.collapses(i, balls, contact) || collapse;
    return collapse ? stop(Verdict::collapse, collapse_reason(world.regularise, support), cluster(balls)) : Verdict::go_on;
  }

  [[nodiscard]] static bool is_last(const BallDetail<Real, D>& ball, Party party, std::uint32_t partner,
                                    std::int32_t feature) {
    return ball.last_party == party && ball.last_partner == partner && ball.last_feature == feature;
  }
  [[nodiscard]] static bool is_tie(const BallDetail<Real, D>& ball, const Time<Real>& now, Party party,
                                   std::uint32_t partner, std::int32_t feature) {
    return ball.last_hit == now && !is_last(ball, party, partner, feature);
  }
  static void remember(BallDetail<Real, D>& ball, const Time<Real>& now, Party party, std::uint32_t partner,
                       std::int32_t feature) {
    ball.last_hit = now;
    ball.last_party = party;
    ball.last_partner = partner;
    ball.last_feature = feature;
  }

  [[nodiscard]] static Vector narrowed(const std::array<W, D>& r) {
    Vector v;
    for (int k = 0; k < D; ++k) v[k] = narrow(r[k]);
    return v;
  }
  [[nodiscard]] static bool finite(const Vector& v) {
    for (int k = 0; k < D; ++k)
      if (!(v[k] - v[k] == 0)) return false;
    return true;
  }

  /// The balls and those that they hit last.
  [[nodiscard]] std::vector<std::uint32_t> cluster(std::initializer_list<std::uint32_t> balls) const {
    std::vector<std::uint32_t> all(balls);
    for (const std::uint32_t i : balls)
      for (const std::uint32_t p : watch.partners(i))
        if (std::find(all.begin(), all.end(), p) == all.end()) all.push_back(p);
    std::sort(all.begin(), all.end());
    return all;
  }
  Verdict stop(Verdict verdict, std::string why, std::vector<std::uint32_t> balls) {
    reason = std::move(why);
    reason_balls = std::move(balls);
    return verdict;
  }

  std::vector<std::uint32_t> moved_;
  Sides<Real, D> sides_;
};

}  // namespace carom

#include "carom/sim/collide_together.hpp"
