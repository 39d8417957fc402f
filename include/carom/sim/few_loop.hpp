#pragma once
// The event-driven integrator for few balls: a table of all meetings to come, of which the first happens.
//
// The events are those of EventDriven, bit for bit: the same contact times of the same stored states. What is not settled
// here (a pair close to contact or grazing, a velocity whose rounding is in doubt, an impact that dissipates or is recorded)
// is computed by the code of EventDriven; what is out of the ordinary, two events at one moment above all, is left to it.

#include <atomic>
#include <cmath>
#include <cstdint>

#include "carom/predict/lattice_ray.hpp"
#include "carom/sim/few_run.hpp"
#include "carom/solve/quadratic.hpp"
#include "carom/world/state.hpp"

namespace carom {

/// `Target` is the instruction set that this is compiled for: a name of its own keeps the versions apart.
template <int D, class Target, bool periodic>
class FewLoop {
 public:
  using Run = FewRun<D>;

  [[gnu::flatten]] static FewHalt advance(Run& run, const Time<double>& until, std::int64_t goal,
                                          const std::atomic<bool>* interrupt) {
    EventCounts& counts = run.collider->counts;
    while (true) {
      if (counts.collisions() >= goal) return FewHalt::events;
      if (interrupt != nullptr && interrupt->load(std::memory_order_relaxed)) return FewHalt::interrupted;
      bool tied = false;
      const std::uint32_t s = run.slots == 1 ? 0 : first(run, tied);
      if (run.slots == 0 || !(run.flight[s] < never<double>())) return periodic ? FewHalt::unusual : FewHalt::idle;
      typename Run::Slot& slot = run.slot[s];
      const std::uint32_t i = slot.low, j = slot.high;
      const Time<double> t = time_of(run, s);
      if (t > until) return FewHalt::until;
      if (i == j) tied = tied || run.wall[i].tied;
      if (tied || t.is_never() || !(t > run.now)) return FewHalt::unusual;
      if (periodic && !slot.settled) {
        if (++run.passages > 8 + 4 * static_cast<std::int64_t>(run.slots)) return FewHalt::unusual;
        detail::predict_pair(run, s);
        continue;
      }
      const bool usual = run.plain && (i == j ? hit_wall(run, i, t) : hit_ball(run, slot, t));
      if (!usual) {
        const Verdict verdict = detail::collide_slot(run, s, t);
        if (verdict != Verdict::go_on) {
          run.now = t;
          return verdict == Verdict::collapse ? FewHalt::collapse : FewHalt::non_finite;
        }
      }
      run.now = t;
      run.passages = 0;
      if (t.epoch - run.base > most_epochs) detail::rebase(run);
      look(run, i, j);
      if (i != j) look(run, j, i);
    }
  }

 private:
  using Ball = carom::Ball<double, D>;
  static constexpr std::int64_t most_epochs = std::int64_t{1} << 20;

  // --- what is due ---

  /// The slot whose event comes first; `tied`: two come at one moment.
  CAROM_INLINE static std::uint32_t first(const Run& run, bool& tied) {
    double least_due = run.due[0], second = never<double>();
    std::uint32_t at = 0;
    if (run.slots <= 6) {
      for (std::uint32_t s = 1; s < run.slots; ++s) {
        const double d = run.due[s];
        const bool less = d < least_due;
        const double loser = less ? least_due : d;
        second = loser < second ? loser : second;
        least_due = less ? d : least_due;
        at = less ? s : at;
      }
    } else {
      const double* const due = run.due.data();
      Lanes one = load(due), two = spread(never<double>());
      LaneMask where = {0, 1, 2, 3}, best = where;
      for (std::uint32_t s = lanes; s < run.slots; s += lanes) {
        const Lanes d = load(due + s);
        where += lanes;
        const LaneMask less = d < one;
        two = least(two, less ? one : d);
        best = less ? where : best;
        one = less ? d : one;
      }
      const Lanes all = least_of(one);
      const int k = __builtin_ctz(static_cast<unsigned>(sign_bits(one == all)) | 16u);
      least_due = all[0];
      at = static_cast<std::uint32_t>(best[k & 3]);
      const Lanes rest = (LaneMask{0, 1, 2, 3} == LaneMask{} + k) ? two : least(one, two);
      second = least_of(rest)[0];
    }
    // Three roundings of numbers not above it lie between a due time and the true one.
    if (second - least_due > 0x1p-50 * std::fabs(second) + 0x1p-50 || !(second < never<double>())) return at;
    return detail::first_of_close(run, second, tied);
  }

  /// `since`: the moment now, from which the flight is.
  CAROM_INLINE static void set(Run& run, std::uint32_t s, double flight, double since) {
    run.flight[s] = flight;
    run.due[s] = since + flight;
  }
  CAROM_INLINE static double now_since_base(const Run& run) {
    return static_cast<double>(run.now.epoch - run.base) + run.now.offset;
  }

  // --- collisions ---

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

  /// False if it is not certain what follows: nothing has been written then.
  CAROM_INLINE static bool hit_ball(Run& run, const typename Run::Slot& slot, const Time<double>& t) {
    const std::uint32_t i = slot.low, j = slot.high;
    const Ball &a = run.world->balls[i], &b = run.world->balls[j];
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
    return true;
  }
  static constexpr double most_periods = 64;  ///< detail::start_few relies on it

  CAROM_INLINE static bool hit_wall(Run& run, std::uint32_t i, const Time<double>& t) {
    const std::uint32_t which = run.wall[i].which;
    if (which == Run::some_wall) return false;
    const Ball& ball = run.world->balls[i];
    Exactness<double>& exactness = run.collider->exactness;
    double x[D], v[D];
    fly(ball, t, x);
    if (which < 2 * D) {  // the velocity across is turned round, exactly [papers/impact.md]
      const int axis = static_cast<int>(which / 2);
      for (int k = 0; k < D; ++k) v[k] = ball.velocity[k] + 0.0;
      v[axis] = -ball.velocity[axis];
      const double gap = (which % 2 == 0 ? x[axis] - run.face[which] : run.face[which] - x[axis]) - ball.radius;
      note_gap(exactness, gap, ball.radius);
      const auto& face = run.world->walls.faces[static_cast<std::size_t>(run.face_row[which])];
      write(run, i, x, v, t, Party::wall, index(face.wall), face.feature);
    } else {
      const auto& sphere = run.world->walls.spheres[run.spheres[which - 2 * D]];
      double high[D], low[D] = {}, still[D] = {}, old[D], excess, square = 0;
      for (int k = 0; k < D; ++k) {
        const double r = x[k] - sphere.centre[k];
        square = k == 0 ? r * r : square + r * r;
        high[k] = sphere.inside ? r : -r;
        old[k] = ball.velocity[k];
      }
      if (!elastic_impact<D>(run.sphere_pair[i][which - 2 * D], high, low, old, still, v, nullptr, excess)) return false;
      const double distance = __builtin_sqrt(square);
      note_gap(exactness, (sphere.inside ? sphere.radius - distance : distance - sphere.radius) - ball.radius, ball.radius);
      write(run, i, x, v, t, Party::wall, index(sphere.wall), sphere.feature);
    }
    ++run.collider->counts.ball_wall;
    return true;
  }

  // --- predictions ---

  /// All that may happen to ball i, which has just hit `hit` (itself: a wall).
  CAROM_INLINE static void look(Run& run, std::uint32_t i, std::uint32_t hit) {
    const double now = now_since_base(run);
    if constexpr (periodic) {
      for (std::uint32_t k = 0; k < run.other_count[i]; ++k) {
        const std::uint32_t j = run.others[i][k];
        if (j == hit && i > hit) continue;  // seen from the other
        look_along(run, run.slot_of[i][j], i, j, j == hit, now);
      }
    } else {
      if (run.slot_of[i][i] != Run::no_slot) look_at_walls(run, i, i == hit, now);
      for (std::uint32_t k = 0; k < run.other_count[i]; k += lanes) look_at_four(run, i, k, hit, now);
    }
  }

  /// Four of the partners of ball i, none of which was written at the moment now but `hit`.
  CAROM_INLINE static void look_at_four(Run& run, std::uint32_t i, std::uint32_t from, std::uint32_t hit, double now) {
    const Ball* const balls = run.world->balls.data();
    const Ball& own = balls[i];
    const std::uint32_t* const j = run.others[i].data() + from;
    const Ball &b0 = balls[j[0]], &b1 = balls[j[1]], &b2 = balls[j[2]], &b3 = balls[j[3]];
    const auto epochs = [&own](const Ball& ball) { return static_cast<double>(own.time.epoch - ball.time.epoch); };
    const Lanes epoch = {epochs(b0), epochs(b1), epochs(b2), epochs(b3)};
    const Lanes offset = {b0.time.offset, b1.time.offset, b2.time.offset, b3.time.offset};
    Lanes r[D], g[D];
    for (int k = 0; k < D; ++k) {
      r[k] = Lanes{b0.position[k], b1.position[k], b2.position[k], b3.position[k]};
      g[k] = Lanes{b0.velocity[k], b1.velocity[k], b2.velocity[k], b3.velocity[k]};
    }
    const Lanes lag = epoch + (spread(own.time.offset) - offset);
    for (int k = 0; k < D; ++k) {
      r[k] = (r[k] + g[k] * lag) - own.position[k];
      g[k] = g[k] - own.velocity[k];
    }
    int open;
    const Lanes flight = flights(r, g, load(run.sigma[i].data() + from), open);
    for (int m = 0; m < lanes && from + static_cast<std::uint32_t>(m) < run.other_count[i]; ++m) {
      const std::uint32_t s = run.slot_of[i][j[m]];
      if (j[m] == hit) {  // not again before one of them is hit
        set(run, s, never<double>(), now);
      } else if ((open >> m & 1) != 0) {
        detail::predict_pair(run, s);
      } else {
        set(run, s, flight[m], now);
      }
    }
  }

  /// meet_time in every lane; the bits of `open` are those of lanes that plain arithmetic does not settle.
  CAROM_INLINE static Lanes flights(const Lanes (&r)[D], const Lanes (&g)[D], const Lanes& sigma, int& open) {
    Lanes b = r[0] * g[0], rr = r[0] * r[0], a = g[0] * g[0], cross;
    for (int k = 1; k < D; ++k) {
      b += r[k] * g[k];
      rr += r[k] * r[k];
      a += g[k] * g[k];
    }
    if constexpr (D == 2) {
      const Lanes z = r[0] * g[1] - r[1] * g[0];
      cross = z * z;
    } else {
      const Lanes cx = r[1] * g[2] - r[2] * g[1], cy = r[2] * g[0] - r[0] * g[2], cz = r[0] * g[1] - r[1] * g[0];
      cross = cx * cx + cy * cy + cz * cz;
    }
    const Lanes ss = sigma * sigma, ass = a * ss, c = rr - ss, d = ass - cross;
    const LaneMask parting = (b >= 0.0) & (rr > carom::detail::apart * ss);
    const LaneMask far = c > carom::detail::near_contact * ss;
    const LaneMask passing = far & (-d > carom::detail::no_root * (a * rr) + carom::detail::no_underflow);
    const LaneMask meeting = far & (d > carom::detail::near_grazing * ass + carom::detail::no_underflow) & ~parting;
    open = sign_bits(~(parting | passing | meeting));
    const Lanes t = c / (sqrt(d) - b);
    return meeting ? t : spread(never<double>());
  }

  /// Balls i and j in a periodic space, of which i was written just now: four columns of images at a time. `again`: so was j,
  /// and they are in contact.
  CAROM_INLINE static void look_along(Run& run, std::uint32_t s, std::uint32_t i, std::uint32_t j, bool again, double now) {
    const Ball* const balls = run.world->balls.data();
    typename Run::Slot& slot = run.slot[s];
    const Ball &own = balls[i], &other = balls[j];
    const double lag = elapsed(other.time, own.time), sign = i < j ? 1.0 : -1.0;
    double r[D], g[D], speed = 0;
    for (int k = 0; k < D; ++k) {
      r[k] = sign * ((other.position[k] + other.velocity[k] * lag) - own.position[k]);
      g[k] = sign * (other.velocity[k] - own.velocity[k]);
      speed += std::fabs(g[k]);
    }
    slot.settled = true;
    if (speed == 0) return set(run, s, never<double>(), now);
    const LatticeRay<D> ray(r, g, slot.pair.sigma, run.edge, run.per_edge);
    const Contact<D>* const contact = again ? run.world->details[i].contacts.data() : nullptr;
    double column = ray.first();
    for (int batch = 0; batch < 2; ++batch, column += lanes) {
      const Lanes columns = Lanes{0, 1, 2, 3} + column;
      Lanes row[D], best = spread(never<double>()), image[D];
      for (int k = 0; k < D; ++k) {
        row[k] = k == ray.axis ? ray.sense * columns : ray.row(k, columns);
        image[k] = spread(0);
      }
      int open = 0;  // columns with what is not settled
      for (int corner = 0; corner < 1 << (D - 1); ++corner) {
        Lanes n[D], at[D], v[D];
        int bit = 0, unsettled;
        LaneMask touching = LaneMask{} - 1;
        for (int k = 0; k < D; ++k) {
          n[k] = row[k] + (k == ray.axis ? 0.0 : static_cast<double>(corner >> bit & 1));
          bit += k != ray.axis;
          at[k] = r[k] + n[k] * run.edge[k];
          v[k] = spread(g[k]);
          if (again) touching = touching & (n[k] == static_cast<double>(i < j ? contact->image[k] : -contact->image[k]));
        }
        Lanes t = flights(at, v, spread(slot.pair.sigma), unsettled);
        if (again) {
          unsettled &= ~sign_bits(touching);
          t = touching ? spread(never<double>()) : t;
        }
        open |= unsettled;
        const LaneMask sooner = t < best;
        best = sooner ? t : best;
        for (int k = 0; k < D; ++k) image[k] = sooner ? n[k] : image[k];
      }
      // Columns do not overlap: what is met in a later one comes later.
      if (open != 0) {
        const unsigned meeting = static_cast<unsigned>(sign_bits(best < never<double>()));
        const unsigned until_then = (meeting & -meeting) * 2 - 1;
        if ((static_cast<unsigned>(open) & until_then) != 0) return detail::predict_pair(run, s);
      }
      const double flight = least_of(best)[0];
      if (flight < never<double>()) {
        const int m = __builtin_ctz(static_cast<unsigned>(sign_bits(best == flight)) | 16u) & 3;
        for (int k = 0; k < D; ++k) slot.image[k] = static_cast<std::int32_t>(image[k][m]);
        return set(run, s, flight, now);
      }
    }
    slot.settled = false;
    slot.column = column;
    set(run, s, ray.entry(slot.column), now);
  }

  /// `hit`: ball i has just hit the wall that stands in its entry.
  CAROM_INLINE static void look_at_walls(Run& run, std::uint32_t i, bool hit, double now) {
    const Ball& ball = run.world->balls[i];
    typename Run::Wall& wall = run.wall[i];
    const std::uint32_t s = run.slot_of[i][i], last = wall.which;
    double first = never<double>(), second = never<double>();
    std::uint32_t which = 0;
    const auto offer = [&](double t, std::uint32_t w) {
      const bool less = t < first;
      const double loser = less ? first : t;
      second = loser < second ? loser : second;
      which = less ? w : which;
      first = less ? t : first;
    };
    for (int k = 0; k < D; ++k) {
      const double v = ball.velocity[k];
      const int side = v > 0;
      const double face = run.face[static_cast<std::size_t>(2 * k + side)];
      const double gap = (side != 0 ? face - ball.position[k] : ball.position[k] - face) - ball.radius;
      const double speed = std::fabs(v), flight = gap > 0 ? gap / speed : 0.0;
      offer(speed > 0 ? flight : never<double>(), static_cast<std::uint32_t>(2 * k + side));
    }
    for (std::uint32_t n = 0; n < run.spheres.size(); ++n)
      offer(flight_to_sphere(run, i, n, hit && last == 2 * D + n), 2 * D + n);
    if (run.other_walls) {
      wall.event = detail::first_other_wall(run, i);
      if (wall.event.kind != EventKind::none) {
        offer(elapsed(ball.time, wall.event.time), Run::some_wall);
      }
    }
    // Two that may end at one tick of the clock are left to the order of events.
    if (second < never<double>() && !(second - first > 0x1p-51 + 0x1p-50 * first)) return detail::predict_walls(run, i);
    wall.which = which;
    wall.tied = false;
    set(run, s, first, now);
  }

  CAROM_INLINE static double flight_to_sphere(const Run& run, std::uint32_t i, std::uint32_t n, bool hit) {
    const Ball& ball = run.world->balls[i];
    const auto& sphere = run.world->walls.spheres[run.spheres[n]];
    Vec<double, D> r, v;
    for (int k = 0; k < D; ++k) {
      r[k] = ball.position[k] - sphere.centre[k];
      v[k] = ball.velocity[k];
    }
    const double b = dot<double, D>(r, v), rr = dot<double, D>(r, r);
    if (sphere.inside) {
      const double rho = sphere.radius - ball.radius, a = dot<double, D>(v, v), ss = rho * rho, depth = ss - rr;
      const double d = a * ss - cross_squared<double, D>(r, v);
      if (d > carom::detail::near_grazing * (a * ss) + carom::detail::no_underflow) {
        if (b < 0.0 && depth > -ss) return (__builtin_sqrt(d) - b) / a;
        if (!hit && !(b < 0.0) && depth > carom::detail::near_contact * ss) return depth / (b + __builtin_sqrt(d));
      }
      return detail::flight_to_sphere(run, i, n);
    }
    if (hit) return never<double>();
    const double sigma = sphere.radius + ball.radius, ss = sigma * sigma, c = rr - ss;
    if (b >= 0.0 && rr > carom::detail::apart * ss) return never<double>();
    const double a = dot<double, D>(v, v), ass = a * ss, d = ass - cross_squared<double, D>(r, v);
    if (c > carom::detail::near_contact * ss) {
      if (-d > carom::detail::no_root * (a * rr) + carom::detail::no_underflow) return never<double>();
      if (d > carom::detail::near_grazing * ass + carom::detail::no_underflow) return c / (__builtin_sqrt(d) - b);
    }
    return detail::flight_to_sphere(run, i, n);
  }
};

}  // namespace carom
