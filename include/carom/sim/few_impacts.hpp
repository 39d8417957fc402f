#pragma once
// What happens in the loop of few balls when two bodies meet: the impact of plain cases, written as EventDriven writes it.

#include <cmath>
#include <cstdint>

#include "carom/sim/few_run.hpp"
#include "carom/world/state.hpp"

namespace carom {

/// `Target` is the instruction set that this is compiled for: a name of its own keeps the versions apart.
template <int D, class Target, bool periodic>
class FewImpacts {
 public:
  using Run = FewRun<D>;
  using Ball = carom::Ball<double, D>;

  /// False if it is not certain what follows: nothing has been written then.
  CAROM_INLINE static bool hit_ball(Run& run, const typename Run::Slot& slot, const Time<double>& t) {
    const std::uint32_t i = slot.low, j = slot.high;
    const Ball &a = run.world->balls[i], &b = run.world->balls[j];
    if (run.other_walls && (a.radius == 0 || b.radius == 0)) return false;  // points have sides to be kept on
    double xa[D], xb[D], high[D], low[D], va[D], vb[D], after_a[D], after_b[D], excess;
    fly(a, t, xa);
    fly(b, t, xb);
    bool near = true;
    for (int k = 0; k < D; ++k) {
      va[k] = a.velocity[k];
      vb[k] = b.velocity[k];
      if constexpr (periodic) {
        const double turns = slot.image[k];
        near = near && std::fabs(turns) <= most_periods;
        const DoubleDouble shift = two_prod(turns, run.edge[k]), image = two_sum(xb[k], shift.hi);
        const DoubleDouble r = two_diff(image.hi, xa[k]);
        high[k] = r.hi;
        low[k] = r.lo + (image.lo + shift.lo);
      } else {
        const DoubleDouble r = two_diff(xb[k], xa[k]);
        high[k] = r.hi;
        low[k] = r.lo;
      }
    }
    if (!near || !elastic_impact<D>(slot.pair, high, low, va, vb, after_a, after_b, excess)) return false;
    // The gap is (r.r - sigma^2) / (|r| + sigma): it matters if it is larger than any before.
    const double sigma = slot.pair.sigma;
    const Exactness<double>& known = run.collider->exactness;
    const double most = known.max_gap_error_relative * sigma;
    if (!(std::fabs(excess) < 1.96 * sigma * (most < known.max_gap_error ? most : known.max_gap_error))) return false;
    FewImpact<D>& told = run.told;
    if (run.tell != nullptr) {
      if (!elastic_impulse<D>(slot.pair, high, low, va, vb, told.impulse)) return false;
      note(run, told, 0, i, xa, t);
      note(run, told, 1, j, xb, t);
      told.image = slot.image;
    }
    const Turns<D> turns_a = write(run, i, xa, after_a, t, Party::ball, j, 0);
    const Turns<D> turns_b = write(run, j, xb, after_b, t, Party::ball, i, 0);
    Contact<D>&own = run.world->details[i].contacts[0], &other = run.world->details[j].contacts[0];
    own.partner_stamp = other.own_stamp;
    other.partner_stamp = own.own_stamp;
    if constexpr (periodic)
      for (int k = 0; k < D; ++k) {
        const std::size_t m = static_cast<std::size_t>(k);
        own.image[k] = slot.image[k] + static_cast<std::int32_t>(turns_b[m] - turns_a[m]);
        other.image[k] = -own.image[k];
      }
    ++run.collider->counts.ball_ball;
    if (run.tell != nullptr) run.tell(run);
    return true;
  }
  CAROM_INLINE static bool hit_wall(Run& run, std::uint32_t i, const Time<double>& t) {
    const std::uint32_t which = run.wall[i].which;
    if (which == Run::some_wall) return hit_piece(run, i, t);
    const Ball& ball = run.world->balls[i];
    Exactness<double>& exactness = run.collider->exactness;
    double x[D], v[D];
    FewImpact<D>& told = run.told;
    fly(ball, t, x);
    if (run.other_walls && ball.radius == 0) {
      run.wall[i].segment = nullptr;  // what is hit is neither
      run.wall[i].arc = nullptr;
      if (!detail::stays_clear(run, i, x)) return false;
    }
    if (which < 2 * D) {  // the velocity across is turned round, exactly [papers/impact.md]
      const int axis = static_cast<int>(which / 2);
      for (int k = 0; k < D; ++k) v[k] = ball.velocity[k] + 0.0;
      v[axis] = -ball.velocity[axis];
      if (run.tell != nullptr) {
        note(run, told, 0, i, x, t);
        told.image = Image<D>{};
        told.impulse = 2 * std::fabs(ball.velocity[axis]) * run.world->details[i].mass;
        for (int k = 0; k < D; ++k) told.from_wall[k] = k != axis ? 0.0 : which % 2 == 0 ? 1.0 : -1.0;
      }
      const double gap = (which % 2 == 0 ? x[axis] - run.face[which] : run.face[which] - x[axis]) - ball.radius;
      note_gap(exactness, gap, ball.radius);
      const auto& face = run.world->walls.faces[static_cast<std::size_t>(run.face_row[which])];
      write(run, i, x, v, t, Party::wall, index(face.wall), face.feature);
    } else {
      const auto& sphere = run.world->walls.spheres[run.spheres[which - 2 * D]];
      double high[D], low[D] = {}, still[D] = {}, old[D], excess, square = 0;
      for (int k = 0; k < D; ++k) {
        const double r = x[k] - (periodic ? run.wall[i].centre[k] : sphere.centre[k]);
        square = k == 0 ? r * r : square + r * r;
        high[k] = sphere.inside ? r : -r;
        old[k] = ball.velocity[k];
      }
      if (!elastic_impact<D>(run.sphere_pair[i][which - 2 * D], high, low, old, still, v, nullptr, excess)) return false;
      if (run.tell != nullptr) {
        if (!elastic_impulse<D>(run.sphere_pair[i][which - 2 * D], high, low, old, still, told.impulse)) return false;
        note(run, told, 0, i, x, t);
        for (int k = 0; k < D; ++k) told.from_wall[k] = -high[k];
        told.image = run.wall[i].image;
      }
      const double distance = __builtin_sqrt(square);
      note_gap(exactness, (sphere.inside ? sphere.radius - distance : distance - sphere.radius) - ball.radius, ball.radius);
      const Turns<D> turns = write(run, i, x, v, t, Party::wall, index(sphere.wall), sphere.feature);
      if constexpr (periodic)
        for (int k = 0; k < D; ++k)
          run.world->details[i].contacts[0].image[k] = run.wall[i].image[k] - static_cast<std::int32_t>(turns[static_cast<std::size_t>(k)]);
    }
    ++run.collider->counts.ball_wall;
    if (run.tell != nullptr) run.tell(run);
    return true;
  }

  /// The segment or arc that stands in the entry of ball i.
  CAROM_INLINE static bool hit_piece(Run& run, std::uint32_t i, const Time<double>& t) {
    if constexpr (D == 2 && !periodic) {
      const typename Run::Wall& wall = run.wall[i];
      if (wall.segment == nullptr && wall.arc == nullptr) return false;
      const Ball& ball = run.world->balls[i];
      const double side = wall.event.side;
      double x[D], v[D], high[D], low[D] = {}, still[D] = {}, old[D], excess;
      fly(ball, t, x);
      const Vec<double, D> at(x[0], x[1]);
      const ElasticPair* pair = &run.flat_pair[i];
      double gap;
      if (wall.segment != nullptr) {
        gap = wall.segment->gap(at) - ball.radius;
        for (int k = 0; k < D; ++k) high[k] = -(side * wall.segment->direction[k]);
      } else {
        gap = std::fabs(wall.arc->height(at)) - ball.radius;
        for (int k = 0; k < D; ++k) high[k] = -((wall.arc->centre[k] - x[k]) * side);
        pair = &run.arc_pair[i][static_cast<std::size_t>(wall.arc - run.world->walls.arcs.data())][side > 0 ? 1 : 0];
      }
      for (int k = 0; k < D; ++k) old[k] = ball.velocity[k];
      if (!elastic_impact<D>(*pair, high, low, old, still, v, nullptr, excess)) return false;
      if (ball.radius == 0 && !detail::stays_clear(run, i, x)) return false;
      FewImpact<D>& told = run.told;
      if (run.tell != nullptr) {
        if (!elastic_impulse<D>(*pair, high, low, old, still, told.impulse)) return false;
        note(run, told, 0, i, x, t);
        for (int k = 0; k < D; ++k) told.from_wall[k] = -high[k];
        told.image = Image<D>{};
        told.side = wall.event.side;
      }
      note_gap(run.collider->exactness, gap, ball.radius);
      write(run, i, x, v, t, Party::wall, wall.event.partner, wall.event.feature);
      run.world->details[i].contacts[0].side = wall.event.side;
      ++run.collider->counts.ball_wall;
      if (run.tell != nullptr) run.tell(run);
      return true;
    }
    return false;
  }

 private:
  static constexpr double most_periods = 64;  ///< detail::start_few relies on it

  /// What a record tells of ball i as it was before.
  CAROM_INLINE static void note(const Run& run, FewImpact<D>& told, int side, std::uint32_t i, const double* x,
                                const Time<double>& t) {
    told.time = t;
    told.side = 0;
    if (side == 0) told.low = i;
    told.high = i;
    for (int k = 0; k < D; ++k) {
      told.at[side][k] = x[k];
      told.before[side][k] = run.world->balls[i].velocity[k];
    }
    told.previous[side] = run.world->details[i].last_hit;
  }

  CAROM_INLINE static void fly(const Ball& ball, const Time<double>& t, double* x) {
    const double s = elapsed(ball.time, t);
    for (int k = 0; k < D; ++k) x[k] = ball.position[k] + ball.velocity[k] * s;
  }

  /// `wrap` for one coordinate, without a branch that cannot be foreseen: x - 0 * edge is x.
  CAROM_INLINE static std::int64_t wrap_coordinate(double lower, double edge, double& x) {
    const double n = std::floor((x - lower) / edge) + 0.0;
    x -= n * edge;
    std::int64_t turns = static_cast<std::int64_t>(n);
    if (x < lower) {
      x += edge;
      --turns;
    }
    if (x >= lower + edge) {
      x -= edge;
      ++turns;
    }
    return turns;
  }

  /// Ball i is at x with velocity v at time t, and in one contact. Gives the periods taken out of x.
  CAROM_INLINE static Turns<D> write(Run& run, std::uint32_t i, const double* x, const double* v, const Time<double>& t,
                                     Party party, std::uint32_t partner, std::int32_t feature) {
    Ball& ball = run.world->balls[i];
    BallDetail<double, D>& detail = run.world->details[i];
    Vec<double, D> at;
    double reach = detail.reach;
    for (int k = 0; k < D; ++k) {
      const double old = std::fabs(ball.position[k]), next = std::fabs(x[k]);
      const double far = old < next ? next : old;
      reach = reach < far ? far : reach;
      at[k] = x[k];
    }
    detail.reach = reach;
    Turns<D> turns{};
    if (periodic && !ball.fixed)
      for (int k = 0; k < D; ++k) {
        const std::size_t m = static_cast<std::size_t>(k);
        turns[m] = wrap_coordinate(run.world->space.lower[k], run.edge[k], at[k]);
        detail.image[m] += turns[m];
      }
    for (int k = 0; k < D; ++k) {
      ball.position[k] = at[k];
      ball.velocity[k] = v[k];
    }
    ball.time = t;
    ++ball.stamp;
    ball.in_contact = true;
    if (detail.contacts.size() != 1) detail::one_contact(detail);
    Contact<D>& contact = detail.contacts[0];
    contact = Contact<D>{};
    contact.party = party;
    contact.partner = partner;
    contact.feature = feature;
    contact.acted = true;
    contact.own_stamp = ball.stamp;
    detail.last_hit = t;
    detail.last_party = party;
    detail.last_partner = partner;
    detail.last_feature = feature;
    return turns;
  }
};

}  // namespace carom
