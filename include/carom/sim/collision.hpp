#pragma once
// One collision: bring the parties to the moment of contact, resolve the impact, write what has changed, keep the books.

#include <cmath>
#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "carom/law/impact.hpp"
#include "carom/predict/ball_wall.hpp"
#include "carom/predict/event.hpp"
#include "carom/sim/books.hpp"
#include "carom/sim/collapse_watch.hpp"
#include "carom/sim/record.hpp"
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
  std::string reason;                        ///< of a verdict other than go_on
  std::vector<std::uint32_t> reason_balls;   ///< whom it concerns

  void reset(const WorldType& world) {
    if (world.restitution.any_below_one()) watch.reset(world.balls.size());
  }

  /// The balls whose stored state the last collision wrote.
  [[nodiscard]] std::span<const std::uint32_t> moved() const noexcept { return moved_; }

  template <class Sink>
  Verdict collide(WorldType& world, const M& motion, const Event<Real, D>& event, Sink&& sink) {
    moved_.clear();
    exactness.unresolved += event.unresolved;
    return event.kind == EventKind::ball_ball ? ball_ball(world, motion, event, sink) : ball_wall(world, motion, event, sink);
  }

 private:
  using W = Wide<Real>;

  template <class Sink>
  Verdict ball_ball(WorldType& world, const M& motion, const Event<Real, D>& event, Sink&& sink) {
    const std::uint32_t i = event.ball, j = event.partner;
    const Time<Real>& now = event.time;
    const BallDetail<Real, D>&a = world.details[i], &b = world.details[j];
    if (detail::infinite(a.mass) && detail::infinite(b.mass))
      return stop(Verdict::collapse, "two balls of infinite mass meet, and no law says what follows", {i, j});

    Impact<Real, D> impact;
    impact.va = velocity_at(motion, world, i, now);
    impact.vb = velocity_at(motion, world, j, now);
    impact.ma = a.mass;
    impact.mb = b.mass;
    impact.e = world.restitution.between(a.material, b.material);
    const Vector xa = position_at(motion, world, i, now), xb = position_at(motion, world, j, now);
    for (int k = 0; k < D; ++k) {
      impact.r[k] = wide_difference<Real>(xb[k], xa[k]);
      if (world.space.periodic()) impact.r[k] = impact.r[k] + wide_product<Real>(Real(event.image[k]), world.space.edge[k]);
    }
    const Real gap = note_gap(impact.r, world.balls[i].radius + world.balls[j].radius,
                              world.balls[i].radius + world.balls[j].radius);
    if constexpr (D == 1) impact.r[0] = W(Real(side_on_line(world, i, j, event.image)));

    const Outcome<Real, D> outcome = resolve_impact(impact);
    const bool tie = is_tie(a, now, Party::ball, j, 0) || is_tie(b, now, Party::ball, i, 0);
    const Time<Real> before_a = a.last_hit, before_b = b.last_hit;
    const auto turns_a = write_state(world, i, xa, outcome.va, now);
    const auto turns_b = write_state(world, j, xb, outcome.vb, now);
    moved_.push_back(i);
    moved_.push_back(j);

    Contact<D> contact{Party::ball, j, 0, Image<D>{}, 0, true, world.balls[i].stamp, world.balls[j].stamp};
    for (int k = 0; k < D; ++k)
      contact.image[k] = static_cast<std::int32_t>(event.image[k] + turns_b[k] - turns_a[k]);
    hold_contact(world, i, contact);
    contact.partner = i;
    std::swap(contact.own_stamp, contact.partner_stamp);
    contact.image = -contact.image;
    hold_contact(world, j, contact);

    ++counts.ball_ball;
    counts.ties += tie;
    book(outcome);
    remember(world.details[i], now, Party::ball, j, 0);
    remember(world.details[j], now, Party::ball, i, 0);
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
    if (impact.e < 1 && watch.watching()) {
      const bool one = watch.collapses(i, now), other = watch.collapses(j, now);
      if (one || other) return stop(Verdict::collapse, collapse_reason(), cluster(world, i, j));
    } else {
      watch.end_streak(i);
      watch.end_streak(j);
    }
    return Verdict::go_on;
  }

  template <class Sink>
  Verdict ball_wall(WorldType& world, const M& motion, const Event<Real, D>& event, Sink&& sink) {
    const std::uint32_t i = event.ball;
    const Time<Real>& now = event.time;
    const BallDetail<Real, D>& a = world.details[i];
    if (detail::infinite(a.mass))
      return stop(Verdict::collapse, "a ball of infinite mass meets a wall, and no law says what follows", {i});

    Impact<Real, D> impact;
    impact.va = velocity_at(motion, world, i, now);
    impact.ma = a.mass;
    impact.mb = std::numeric_limits<Real>::infinity();
    impact.e = world.restitution.at_wall(a.material, event.partner);
    const Vector x = position_at(motion, world, i, now);
    Real gap(0);
    world.walls.with(event.partner, event.feature, [&](const auto& shape) {
      impact.vb = wall_velocity(shape);
      const Vector at = x - wall_drift(world, shape, now);
      const Vector n = outward_normal(shape, at, Vector(impact.va - impact.vb), world.balls[i].radius);
      for (int k = 0; k < D; ++k) impact.r[k] = W(Real(-n[k]));
      gap = note_wall_gap(Real(shape.gap(at)) - world.balls[i].radius, world.balls[i].radius);
    });

    const Outcome<Real, D> outcome = resolve_impact(impact);
    const bool tie = is_tie(a, now, Party::wall, event.partner, event.feature);
    const Time<Real> before = a.last_hit;
    write_state(world, i, x, outcome.va, now);
    moved_.push_back(i);
    hold_contact(world, i,
                 Contact<D>{Party::wall, event.partner, event.feature, {}, event.side, true, world.balls[i].stamp, 0});

    ++counts.ball_wall;
    counts.ties += tie;
    book(outcome);
    remember(world.details[i], now, Party::wall, event.partner, event.feature);
    if constexpr (std::remove_cvref_t<Sink>::wants_records) {
      Record<Real, D> record = record_of(event, impact, outcome, gap, tie);
      fill_party(record.ball, world, i, before);
      record.partner.number = event.partner;
      record.partner.velocity_before = record.partner.velocity_after = impact.vb;
      record.point = world.balls[i].position - record.normal * world.balls[i].radius;
      sink(record);
    }
    if (!finite(outcome.va)) return stop(Verdict::non_finite, "a velocity is no longer a finite number", {i});
    if (impact.e < 1 && watch.watching()) {
      if (watch.collapses(i, now)) return stop(Verdict::collapse, collapse_reason(), {i});
    } else {
      watch.end_streak(i);
    }
    return Verdict::go_on;
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

  template <class Shape>
  Vector outward_normal(const Shape& shape, const Vector& at, const Vector&, const Real&) {
    return shape.normal(at);
  }
  /// A point that meets a vertex has no normal: its velocity is reversed.
  Vector outward_normal(const Sphere<Real, D>& sphere, const Vector& at, const Vector& approach, const Real& radius) {
    if (sphere.radius > 0 || radius > 0) return sphere.normal(at);
    ++exactness.singular;
    return -approach;
  }

  [[nodiscard]] static bool is_tie(const BallDetail<Real, D>& ball, const Time<Real>& now, Party party, std::uint32_t partner,
                                   std::int32_t feature) {
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
    return "infinitely many dissipating impacts in finite time (inelastic collapse or a persistent contact)";
  }
  /// The pair and whoever it touches.
  [[nodiscard]] static std::vector<std::uint32_t> cluster(const WorldType& world, std::uint32_t i, std::uint32_t j) {
    std::vector<std::uint32_t> balls{i, j};
    for (const std::uint32_t k : {i, j})
      for (const Contact<D>& c : world.details[k].contacts)
        if (c.party == Party::ball && std::find(balls.begin(), balls.end(), c.partner) == balls.end())
          balls.push_back(c.partner);
    std::sort(balls.begin(), balls.end());
    return balls;
  }
  Verdict stop(Verdict verdict, std::string why, std::vector<std::uint32_t> balls) {
    reason = std::move(why);
    reason_balls = std::move(balls);
    return verdict;
  }

  std::vector<std::uint32_t> moved_;
};

}  // namespace carom
