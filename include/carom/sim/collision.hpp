#pragma once
// One collision: bring the parties to the moment of contact, resolve the impact, write what has changed, keep the books.

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

#include "carom/law/impact.hpp"
#include "carom/predict/ball_wall.hpp"
#include "carom/predict/event.hpp"
#include "carom/sim/books.hpp"
#include "carom/sim/collapse_watch.hpp"
#include "carom/sim/join.hpp"
#include "carom/sim/record.hpp"
#include "carom/sim/totals.hpp"
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
  std::string reason;                       ///< of a verdict other than go_on
  std::vector<std::uint32_t> reason_balls;  ///< whom it concerns

  void reset(const WorldType& world) {
    for (std::uint32_t i = 0; i < world.balls.size(); ++i) note_potential(world, i);
    if (world.restitution.any_below_one()) watch.reset(world.balls.size());
  }

  /// The balls whose stored state the last collision wrote.
  [[nodiscard]] std::span<const std::uint32_t> moved() const noexcept { return moved_; }

  template <class Sink>
  Verdict collide(WorldType& world, const M& motion, const Event<Real, D>& event, Sink&& sink) {
    moved_.clear();
    exactness.unresolved += event.unresolved;
    return event.kind == EventKind::ball_ball ? ball_ball(world, motion, event, sink)
                                              : ball_wall(world, motion, event, sink);
  }

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
    impact.e = world.restitution.between(a.material, b.material);
    if (detail::infinite(impact.ma) && detail::infinite(impact.mb))
      return stop(Verdict::collapse, "two infinite masses meet, and no law says what follows", {i, j});

    const Vector xa = position_at(motion, world, i, now), xb = position_at(motion, world, j, now);
    for (int k = 0; k < D; ++k) {
      impact.r[k] = wide_difference<Real>(xb[k], xa[k]);
      if (world.space.periodic()) impact.r[k] = impact.r[k] + wide_product<Real>(Real(event.image[k]), world.space.edge[k]);
    }
    const Real sigma = world.balls[i].radius + world.balls[j].radius;
    const Real gap = world.law == LawKind::merge ? Real(0) : note_gap(impact.r, sigma, sigma);
    if constexpr (D == 1) impact.r[0] = W(Real(side_on_line(world, i, j, event.image)));

    const bool tie = is_tie(a, now, Party::ball, j, 0) || is_tie(b, now, Party::ball, i, 0);
    const Time<Real> before_a = a.last_hit, before_b = b.last_hit;
    Outcome<Real, D> outcome;
    if (world.law == LawKind::restitution) {
      outcome = resolve_impact(impact);
      const Turns<D> image_a = a.image, image_b = b.image;
      note_sides(world, i);
      write_motion(world, motion, i, xa, outcome.va, now, moved_);
      keep_sides(world, i);
      note_sides(world, j);
      write_motion(world, motion, j, xb, outcome.vb, now, moved_);
      keep_sides(world, j);
      hold_pair(world, i, j, event.image, image_a, image_b);
    } else {
      outcome = unite(world, motion, event, impact, xa, xb);
    }

    ++counts.ball_ball;
    note_potential(world, i);
    note_potential(world, j);
    counts.ties += tie;
    book(outcome);
    remember(a, now, Party::ball, j, 0);
    remember(b, now, Party::ball, i, 0);
    if constexpr (std::remove_cvref_t<Sink>::wants_records) {
      Record<Real, D> record = record_of(event, impact, outcome, gap, tie);
      fill_party(record.ball, world, i, before_a);
      fill_party(record.partner, world, j, before_b);
      record.partner.velocity_before = impact.vb;
      record.partner.velocity_after = outcome.vb;
      record.point = world.balls[i].position - record.normal * world.balls[i].radius;
      sink(record);
    }
    if (!finite(outcome.va) || !finite(outcome.vb))
      return stop(Verdict::non_finite, "a velocity is no longer a finite number", {i, j});
    if (world.law == LawKind::merge) return check_fit(world, i, now);
    if (world.law == LawKind::stick) return Verdict::go_on;
    if (outcome.impulse == 0 && before_a == now && before_b == now && !tie)
      return stop(Verdict::collapse,
                  impact.e < 1 ? collapse_reason() : "a ball rests against another: the contact never ends", {i, j});
    return watch_streak(impact.e, now, {i, j}, outcome.impulse);
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
    impact.e = world.restitution.at_wall(a.material, event.partner);
    if (detail::infinite(impact.ma))
      return stop(Verdict::collapse, "a ball of infinite mass meets a wall, and no law says what follows", {i});

    const Vector x = position_at(motion, world, i, now);
    Real gap(0);
    world.walls.with(event.partner, event.feature, [&](const auto& shape) {
      impact.vb = wall_velocity(shape);
      const Vector at = x - wall_drift(world, shape, now);
      const Vector n = towards_ball(shape, at, Vector(impact.va - impact.vb), world.balls[i].radius, event.side);
      for (int k = 0; k < D; ++k) impact.r[k] = W(Real(-n[k]));
      gap = note_wall_gap(Real(shape.gap(at) - world.balls[i].radius), world.balls[i].radius);
    });

    const Outcome<Real, D> outcome = resolve_impact(impact);
    const bool tie = is_tie(a, now, Party::wall, event.partner, event.feature);
    const Time<Real> before = a.last_hit;
    note_sides(world, i);
    write_motion(world, motion, i, x, outcome.va, now, moved_);
    hold_contact(world, i,
                 Contact<D>{Party::wall, event.partner, event.feature, {}, event.side, true, world.balls[i].stamp, 0});
    keep_sides(world, i);

    ++counts.ball_wall;
    note_potential(world, i);
    counts.ties += tie;
    book(outcome);
    remember(a, now, Party::wall, event.partner, event.feature);
    if constexpr (std::remove_cvref_t<Sink>::wants_records) {
      Record<Real, D> record = record_of(event, impact, outcome, gap, tie);
      fill_party(record.ball, world, i, before);
      record.partner.number = event.partner;
      record.partner.velocity_before = record.partner.velocity_after = impact.vb;
      record.point = world.balls[i].position - record.normal * world.balls[i].radius;
      sink(record);
    }
    if (!finite(outcome.va)) return stop(Verdict::non_finite, "a velocity is no longer a finite number", {i});
    if (outcome.impulse == 0 && before == now && !tie)
      return stop(Verdict::collapse,
                  impact.e < 1 ? collapse_reason() : "a ball is pressed against a wall: the contact never ends", {i});
    return watch_streak(impact.e, now, {i}, outcome.impulse);
  }

  /// Both balls list the contact, with images relative to where they were stored just now.
  void hold_pair(WorldType& world, std::uint32_t i, std::uint32_t j, const Image<D>& image, const Turns<D>& image_a,
                 const Turns<D>& image_b) {
    Contact<D> contact{Party::ball, j, 0, image, 0, true, world.balls[i].stamp, world.balls[j].stamp};
    for (int k = 0; k < D; ++k)
      contact.image[k] +=
          static_cast<std::int32_t>((world.details[j].image[k] - image_b[k]) - (world.details[i].image[k] - image_a[k]));
    hold_contact(world, i, contact);
    contact.partner = i;
    std::swap(contact.own_stamp, contact.partner_stamp);
    contact.image = -contact.image;
    hold_contact(world, j, contact);
  }

  /// Laws stick and merge: the bodies of both balls go on together.
  Outcome<Real, D> unite(WorldType& world, const M& motion, const Event<Real, D>& event, const Impact<Real, D>& impact,
                         const Vector& xa, const Vector& xb) {
    const std::uint32_t i = event.ball, j = event.partner;
    const Common<Real, D> common = common_velocity(impact.ma, impact.va, impact.mb, impact.vb);
    Outcome<Real, D> outcome{common.velocity, common.velocity, common.impulse, common.dissipated, common.injected};
    Vector beside = xb;
    if (world.space.periodic())
      for (int k = 0; k < D; ++k) beside[k] += Real(event.image[k]) * world.space.edge[k];
    if (world.law == LawKind::stick) {
      join_bodies(world, motion, i, xa, j, beside, event.image, common.velocity, event.time, moved_);
    } else {
      if (detail::infinite(impact.ma)) absorb(world, outcome, impact.mb, j, impact.vb, xb);
      if (detail::infinite(impact.mb)) absorb(world, outcome, impact.ma, i, impact.va, xa);
      if (!detail::infinite(impact.ma) && !detail::infinite(impact.mb)) recount(world, outcome, event, impact.mb);
      merge_balls(world, motion, i, xa, j, beside, common.velocity, event.time, moved_);
    }
    return outcome;
  }

  /// In a periodic space under acceleration the mass of ball j is counted from now on in the periods of ball i. What that
  /// changes in its potential, which is defined up to whole periods only, is booked with what the impact dissipates.
  void recount(const WorldType& world, Outcome<Real, D>& outcome, const Event<Real, D>& event, const Real& m) const {
    if (!world.space.periodic() || !M::accelerated) return;
    for (int k = 0; k < D; ++k) {
      const std::int64_t turns =
          event.image[k] + world.details[event.ball].image[k] - world.details[event.partner].image[k];
      outcome.dissipated =
          outcome.dissipated + W(m) * W(world.acceleration[k]) * wide_product<Real>(Real(turns), world.space.edge[k]);
    }
  }

  /// A finite mass m that an infinite one absorbs leaves all sums, with its whole energy.
  void absorb(const WorldType& world, Outcome<Real, D>& outcome, const Real& m, std::uint32_t i, const Vector& v,
              const Vector& x) const {
    const auto far = unwrapped(world, i, x);
    W energy(Real(0));
    for (int k = 0; k < D; ++k)
      energy = energy + wide_product<Real>(v[k], v[k]) * W(Real(1) / 2) - far[k] * W(world.acceleration[k]);
    outcome.dissipated = W(m) * energy;
    outcome.injected = W(Real(0));
  }

  /// A merged ball must still have room.
  Verdict check_fit(const WorldType& world, std::uint32_t i, const Time<Real>& now) {
    bool fits = true;
    world.walls.for_each([&](const auto& shape) {
      const Vector at = world.balls[i].position - wall_drift(world, shape, now);
      if (shape.gap(at) < world.balls[i].radius && !world.balls[i].fixed) fits = false;
    });
    return fits ? Verdict::go_on
                : stop(Verdict::collapse, "a merged ball grows into a wall, and no law says what follows", {i});
  }

  Verdict watch_streak(const Real& e, const Time<Real>& now, std::initializer_list<std::uint32_t> balls,
                       const Real& impulse) {
    if (!watch.watching()) return Verdict::go_on;
    bool collapse = false;
    for (const std::uint32_t i : balls) {
      if (e < 1) {
        collapse = watch.collapses(i, now, balls, impulse) || collapse;
      } else {
        watch.end_streak(i);
      }
    }
    return collapse ? stop(Verdict::collapse, collapse_reason(), cluster(balls)) : Verdict::go_on;
  }

  /// A point stored next to a segment that it did not hit may have been rounded across it. It holds the side that it flew
  /// on: it touches that segment, and hits it if it closes. Called before its state is written ...
  void note_sides(const WorldType& world, std::uint32_t i) {
    if constexpr (D == 2) {
      sides_.clear();
      const Ball<Real, D>& ball = world.balls[i];
      if (ball.radius > 0) return;
      for (const Segment<Real>& s : world.walls.segments) {
        const Contact<D>* held = wall_contact(world, i, index(s.wall), s.feature);
        const Real height = s.height(Vector(ball.position - drift(world, s, ball.time)));
        sides_.push_back(held != nullptr ? held->side : std::int8_t(height > 0 ? 1 : height < 0 ? -1 : 0));
      }
    }
  }
  /// ... and after it.
  void keep_sides(WorldType& world, std::uint32_t i) {
    using std::abs;
    if constexpr (D == 2) {
      const Ball<Real, D>& ball = world.balls[i];
      for (std::size_t k = 0; k < sides_.size(); ++k) {
        const Segment<Real>& s = world.walls.segments[k];
        const Vector at = ball.position - drift(world, s, ball.time);
        if (sides_[k] == 0 || sides_[k] * s.height(at) > 0) continue;
        if (abs(s.height(at)) > position_doubt(at, s)) continue;  // it flew across the line, beside the segment
        if (dot<Real, D>(s.along, at - s.from) < 0 || dot<Real, D>(s.along, at - s.to) > 0) continue;
        if (wall_contact(world, i, index(s.wall), s.feature) != nullptr) continue;
        hold_contact(world, i, Contact<D>{Party::wall, index(s.wall), s.feature, {}, sides_[k], false, 0, 0});
      }
    }
  }

  /// How far rounding can put a stored point off its path, and the height that is computed of it off the truth: at most 8 u
  /// of the coordinates in play (two roundings of the advance, three of the height).
  [[nodiscard]] static Real position_doubt(const Vec<Real, 2>& at, const Segment<Real>& s) {
    using std::abs;
    return 8 * unit_roundoff<Real>() * (abs(at[0]) + abs(at[1]) + abs(s.from[0]) + abs(s.from[1]));
  }

  // A wall as the infinite mass of an impact.
  static Vector wall_velocity(const Face<Real, D>&) { return Vector::Zero(); }
  template <class Shape>
  static Vector wall_velocity(const Shape& shape) {
    return shape.velocity;
  }
  static Vector wall_drift(const WorldType&, const Face<Real, D>&, const Time<Real>&) { return Vector::Zero(); }
  template <class Shape>
  static Vector wall_drift(const WorldType& world, const Shape& shape, const Time<Real>& now) {
    return drift(world, shape, now);
  }

  /// Direction of the impulse that the wall gives, of any length.
  template <class Shape>
  Vector towards_ball(const Shape& shape, const Vector& at, const Vector&, const Real&, std::int8_t) {
    return shape.normal(at);
  }
  Vector towards_ball(const Segment<Real>& segment, const Vector& at, const Vector&, const Real&,
                      std::int8_t side) requires(D == 2) {
    return side * segment.normal(at);
  }
  /// A point that meets a vertex has no normal: its velocity is reversed.
  Vector towards_ball(const Sphere<Real, D>& sphere, const Vector& at, const Vector& approach, const Real& radius,
                      std::int8_t) {
    if (sphere.radius > 0 || radius > 0) return sphere.normal(at);
    ++exactness.singular;
    return -approach;
  }

  [[nodiscard]] static bool is_tie(const BallDetail<Real, D>& ball, const Time<Real>& now, Party party,
                                   std::uint32_t partner, std::int32_t feature) {
    return ball.last_hit == now &&
           !(ball.last_party == party && ball.last_partner == partner && ball.last_feature == feature);
  }
  static void remember(BallDetail<Real, D>& ball, const Time<Real>& now, Party party, std::uint32_t partner,
                       std::int32_t feature) {
    ball.last_hit = now;
    ball.last_party = party;
    ball.last_partner = partner;
    ball.last_feature = feature;
  }

  /// Gap between two balls at contact, |r| - sigma.
  Real note_gap(const std::array<W, D>& r, const Real& sigma, const Real& radii) {
    using std::sqrt;
    W rr(Real(0));
    for (int k = 0; k < D; ++k) rr = rr + r[k] * r[k];
    const W excess = rr - wide_product<Real>(sigma, sigma);
    const Real distance = sqrt(narrow(rr));
    const Real sum = distance + sigma;
    return note_wall_gap(sum > 0 ? Real(narrow(excess) / sum) : Real(0), radii);
  }
  Real note_wall_gap(const Real& gap, const Real& radii) {
    using std::abs;
    const Real size = abs(gap);
    if (size > exactness.max_gap_error) exactness.max_gap_error = size;
    if (radii > 0 && size > exactness.max_gap_error_relative * radii) exactness.max_gap_error_relative = size / radii;
    return gap;
  }

  /// The lowest potential (per mass) at which a ball of finite mass was seen.
  void note_potential(const WorldType& world, std::uint32_t i) {
    if constexpr (M::accelerated) {
      if (detail::infinite(world.details[i].mass)) return;
      const auto x = unwrapped(world, i, world.balls[i].position);
      W p(Real(0));
      for (int k = 0; k < D; ++k) p = p - x[k] * W(world.acceleration[k]);
      if (narrow(p) < books.lowest_potential) books.lowest_potential = narrow(p);
    }
  }

  void book(const Outcome<Real, D>& outcome) {
    using std::abs;
    books.dissipated = books.dissipated + outcome.dissipated;
    if (narrow(outcome.injected) == 0) return;
    books.injected = books.injected + outcome.injected;
    const Real injected = narrow(books.injected);
    if (injected > books.largest_injected) books.largest_injected = injected;
  }

  Record<Real, D> record_of(const Event<Real, D>& event, const Impact<Real, D>& impact, const Outcome<Real, D>& outcome,
                            const Real& gap, bool tie) const {
    using std::sqrt;
    Record<Real, D> record;
    record.time = event.time;
    record.kind = event.kind;
    record.feature = event.feature;
    record.ball.velocity_before = impact.va;
    record.ball.velocity_after = outcome.va;
    Vector n;
    for (int k = 0; k < D; ++k) n[k] = -narrow(impact.r[k]);
    const Real length = sqrt(dot<Real, D>(n, n));
    record.normal = length > 0 ? Vector(n / length) : n;
    record.impulse = outcome.impulse;
    record.gap = gap;
    record.restitution = impact.e;
    record.dissipated = narrow(outcome.dissipated);
    record.injected = narrow(outcome.injected);
    record.tie = tie;
    return record;
  }
  static void fill_party(RecordParty<Real, D>& party, const WorldType& world, std::uint32_t i, const Time<Real>& before) {
    party.number = i;
    party.position = world.balls[i].position;
    party.image = world.details[i].image;
    party.previous_hit = before;
  }

  [[nodiscard]] static bool finite(const Vector& v) {
    for (int k = 0; k < D; ++k)
      if (!(v[k] - v[k] == 0)) return false;
    return true;
  }

  [[nodiscard]] static std::string collapse_reason() {
    return "infinitely many dissipating impacts in finite time: inelastic collapse, or a contact that never ends";
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
  std::vector<std::int8_t> sides_;  // of a point, by segment
};

}  // namespace carom
