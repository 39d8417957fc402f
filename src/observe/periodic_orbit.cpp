#include "carom/observe/periodic_orbit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/core.h>

#include "carom/core/error.hpp"
#include "return_map.hpp"
#include "stability.hpp"

namespace carom {

namespace {

Multi power_of_ten(int exponent) { return pow(Multi(10), exponent); }

/// In which arithmetic, how far apart differences are taken, and how well an orbit is to be closed. In double, central
/// differences are best near the third root of the rounding.
struct Accuracy {
  int digits;     // of the result
  int simulated;  // digits of the simulator; 0: double
  Multi step, closed, certain;

  static int wanted(const Precision& p) { return p.kind == Precision::Kind::decimal ? p.digits : p.is_double() ? 17 : 20; }
  static int working(int digits) { return 3 * digits + 40; }

  Accuracy(int n, bool in_double)
      : digits(in_double ? 15 : n),
        simulated(in_double ? 0 : working(n)),
        step(in_double ? Multi(Multi(1) / 131072) : power_of_ten(-(n + 10))),
        closed(in_double ? power_of_ten(-13) : power_of_ten(-(3 * n / 2 + 10))),
        certain(in_double ? power_of_ten(-6) : power_of_ten(-n)) {}
};

class Refinement {
 public:
  Refinement(const Scene& scene, std::int64_t collisions, const Accuracy& accuracy)
      : accuracy_(accuracy), map_(scene, accuracy.simulated), collisions_(collisions) {}

  PeriodicOrbit operator()() {
    const std::vector<Guess> list = guesses();
    for (std::size_t k = 0; k + 1 < list.size(); ++k) {
      try {
        return from(list[k]);
      } catch (const OrbitError&) {  // the next one may be better
      }
    }
    return from(list.back());
  }

 private:
  [[nodiscard]] std::size_t size() const { return state_.size(); }
  [[nodiscard]] Multi scale(std::size_t i) const { return i < size() / 2 ? length_ : speed_; }

  struct Guess {
    Multis state;
    Multi period;
  };

  /// The middle of the longest flight of one period, and the start of the scene: no collision may be near where the orbit is
  /// closed, and none is to be lost to what grows on the way.
  [[nodiscard]] std::vector<Guess> guesses() const {
    const auto n = static_cast<std::size_t>(collisions_);
    const Circuit first = map_.through(map_.start(), collisions_ + 1);
    if (first.turns.size() < n)
      throw OrbitError(fmt::format("from this start there are {} collisions, and a period has {}. Begin nearer to the orbit",
                                   first.turns.size(), n));
    std::vector<Guess> list;
    const bool goes_on = first.turns.size() > n && first.turns[0].who == first.turns[n].who;
    if (goes_on) {
      const Multi period = first.turns[n].time - first.turns[0].time;
      if (Multis middle = middle_of_longest_flight(first); !middle.empty()) list.push_back({std::move(middle), period});
      if (first.turns[0].time > 0) list.push_back({map_.start(), period});
    } else if (!map_.accelerated() && first.turns[0].time > 0) {
      list.push_back({map_.start(), nearest_return(first)});
    }
    if (list.empty())
      throw OrbitError(fmt::format("from this start collision {} is not with whom collision 1 is. Begin nearer to the orbit, or "
                                   "give its number of collisions with --period", n + 1));
    return list;
  }

  PeriodicOrbit from(const Guess& guess) {
    begin(guess);
    converge();
    return result();
  }

  void begin(const Guess& guess) {
    state_ = guess.state;
    period_ = guess.period;
    Multi square(0);
    for (std::size_t i = size() / 2; i < size(); ++i) square += state_[i] * state_[i];
    speed_ = sqrt(square);
    if (speed_ == 0) {  // at rest under an acceleration
      const Multis rate = map_.flow(state_);
      speed_ = period_ * sqrt(dot(rate, rate));
    }
    length_ = speed_ * period_ / static_cast<double>(collisions_);
    energy_ = map_.energy(state_);
    circuit_ = map_.after(state_, period_);
    if (circuit_.end.empty() || circuit_.turns.size() != static_cast<std::size_t>(collisions_))
      throw OrbitError("the start is too far from an orbit: after one period the ball has met others. Begin nearer to it");
    set_shift();
  }

  [[nodiscard]] Multis middle_of_longest_flight(const Circuit& first) const {
    std::size_t longest = 0;
    const auto flight = [&](std::size_t k) { return Multi(first.turns[k + 1].time - first.turns[k].time); };
    for (std::size_t k = 1; k + 1 < first.turns.size(); ++k)
      if (flight(k) > flight(longest)) longest = k;
    Multis state = map_.after(map_.start(), (first.turns[longest].time + first.turns[longest + 1].time) / 2).end;
    wrap(state);
    return state;
  }

  /// When the flight after the last collision comes nearest to the start, or to where it is in another period of the space.
  [[nodiscard]] Multi nearest_return(const Circuit& first) const {
    const std::size_t n = first.turns.size() > static_cast<std::size_t>(collisions_) ? first.turns.size() - 1 : first.turns.size();
    const Multi last = first.turns[n - 1].time;
    const Multi flight = n > 1 ? Multi((last - first.turns[0].time) / static_cast<double>(n - 1)) : Multi(2 * last);
    const Multis start = map_.start(), at = map_.after(start, last).end;
    if (at.empty()) throw OrbitError("the run from this start stops within its first period");
    Multi along(0), square(0);
    const std::size_t half = at.size() / 2;
    for (std::size_t i = 0; i < half; ++i) {
      const Multi& v = at[half + i];
      Multi gap = start[i] - at[i];
      if (const Multi& edge = map_.periods()[i % map_.dimension()]; edge != 0)
        gap += edge * floor(Multi((v * (flight - first.turns[0].time) - gap) / edge + Multi(1) / 2));
      along += gap * v;
      square += v * v;
    }
    if (!(along > 0)) throw OrbitError("the start is too far from an orbit: after its collisions the ball goes away from it. Begin nearer to it");
    return last + along / square;
  }

  /// Positions into the period of the space that they are wrapped into anyhow.
  void wrap(Multis& state) const {
    const std::size_t d = map_.dimension();
    const Multis at = map_.start();
    for (std::size_t i = 0; i < state.size() / 2; ++i)
      if (const Multi& edge = map_.periods()[i % d]; edge != 0) state[i] -= edge * floor(Multi((state[i] - at[i]) / edge));
  }

  void set_shift() {
    const std::size_t d = map_.dimension();
    shift_.assign(size() / 2, 0);
    for (std::size_t i = 0; i < size() / 2; ++i)
      if (const Multi& edge = map_.periods()[i % d]; edge != 0)
        shift_[i] = static_cast<std::int64_t>(std::llround(static_cast<double>(Multi((circuit_.end[i] - state_[i]) / edge))));
  }

  /// End minus start, in units of length and speed; and what the energy is off.
  [[nodiscard]] Multis residual(const Multis& state, const Circuit& circuit) const {
    Multis r(size() + 1);
    for (std::size_t i = 0; i < size(); ++i) {
      Multi gap = circuit.end[i] - state[i];
      if (i < size() / 2) gap -= map_.periods()[i % map_.dimension()] * Multi(static_cast<double>(shift_[i]));
      r[i] = gap / scale(i);
    }
    r[size()] = (map_.energy(state) - energy_) / unit_of_energy();
    return r;
  }
  [[nodiscard]] Multi unit_of_energy() const { return map_.mass(0) * speed_ * speed_; }

  [[nodiscard]] static Multi largest(const Multis& v) {
    Multi most(0);
    for (const Multi& x : v) most = std::max(most, Multi(abs(x)));
    return most;
  }

  [[nodiscard]] Dense monodromy() const {
    Dense m(size(), size());
    for (std::size_t j = 0; j < size(); ++j) {
      Multis up = state_, down = state_;
      up[j] += accuracy_.step * scale(j);
      down[j] -= accuracy_.step * scale(j);
      const Circuit above = map_.after(up, period_), below = map_.after(down, period_);
      if (above.end.empty() || below.end.empty() || !above.same_sequence(circuit_) || !below.same_sequence(circuit_))
        throw OrbitError("the orbit grazes a wall or meets a corner: beside it the sequence of collisions is another");
      for (std::size_t i = 0; i < size(); ++i) m(i, j) = (above.end[i] - below.end[i]) / (2 * accuracy_.step * scale(i));
    }
    return m;
  }

  [[nodiscard]] Multis scaled_flow(const Multis& at) const {
    Multis f = map_.flow(at);
    for (std::size_t i = 0; i < size(); ++i) f[i] *= length_ / (speed_ * scale(i));
    return f;
  }
  [[nodiscard]] Multis scaled_gradient() const {
    Multis g = map_.energy_gradient(state_);
    for (std::size_t i = 0; i < size(); ++i) g[i] *= scale(i) / unit_of_energy();
    return g;
  }

  /// Rows: the state after a period, no shift along the flow, the energy. Columns: the state, the period.
  [[nodiscard]] Dense jacobian() const {
    const std::size_t m = size();
    Dense j(m + 2, m + 1);
    const Dense map = monodromy();
    const Multis end = scaled_flow(circuit_.end), here = scaled_flow(state_), gradient = scaled_gradient();
    for (std::size_t r = 0; r < m; ++r) {
      for (std::size_t c = 0; c < m; ++c) j(r, c) = map(r, c) - (r == c ? 1 : 0);
      j(r, m) = end[r];
      j(m, r) = gradient[r];
      j(m + 1, r) = here[r];
    }
    return j;
  }

  /// Least squares of j x + r, damped: (j' j + damping) x = -j' r.
  [[nodiscard]] static Multis step(const Dense& j, const Multis& r, const Multi& damping) {
    const std::size_t n = j.columns();
    Dense a(n, n);
    Multis b(n, Multi(0));
    for (std::size_t p = 0; p < n; ++p) {
      for (std::size_t q = 0; q < n; ++q)
        for (std::size_t i = 0; i < j.rows(); ++i) a(p, q) += j(i, p) * j(i, q);
      for (std::size_t i = 0; i < r.size(); ++i) b[p] -= j(i, p) * r[i];
      a(p, p) += damping;
    }
    return solve(std::move(a), std::move(b));
  }

  struct Trial {
    Multis state;
    Multi period;
    Circuit circuit;
  };
  [[nodiscard]] Trial moved(const Multis& x) const {
    Trial t{state_, Multi(period_ + x[size()] * length_ / speed_), {}};
    for (std::size_t i = 0; i < size(); ++i) t.state[i] += x[i] * scale(i);
    if (t.period > 0) t.circuit = map_.after(t.state, t.period);
    return t;
  }

  /// Damping by the square of the residual: quadratic also where orbits are not isolated [YamashitaFukushima2001].
  void converge() {
    constexpr int most_iterations = 100, most_trials = 40;
    bool stuck = false;
    for (iterations_ = 0; iterations_ < most_iterations && !stuck; ++iterations_) {
      const Multis r = residual(state_, circuit_);
      const Multi square = dot(r, r);
      if (largest(r) <= accuracy_.closed) return;
      const Dense j = jacobian();
      Multi damping = std::min(square, Multi(1));
      stuck = true;
      for (int trial = 0; trial < most_trials && stuck; ++trial, damping *= 10) {
        Trial t = moved(step(j, r, damping));
        if (t.circuit.end.empty() || !t.circuit.same_sequence(circuit_)) continue;
        const Multis after = residual(t.state, t.circuit);
        if (!(dot(after, after) < square)) continue;
        state_ = std::move(t.state);
        period_ = t.period;
        circuit_ = std::move(t.circuit);
        stuck = false;
      }
    }
    const Multi left = largest(residual(state_, circuit_));
    if (left > (accuracy_.simulated == 0 ? power_of_ten(-10) : accuracy_.closed))
      throw OrbitError(fmt::format("no orbit with this sequence of collisions near the start: what is left of the difference after "
                                   "one period is {:.2g} of a flight. Begin nearer to an orbit",
                                   static_cast<double>(left)));
  }

  /// What is nothing beside `size` is 0.
  [[nodiscard]] Number shown(const Multi& x, const Multi& size) const {
    return abs(x) < accuracy_.certain * size / 1000 ? Number(0.0) : shown(x);
  }
  [[nodiscard]] Number shown(const Multi& x) const {
    Number n(static_cast<double>(x));
    if (accuracy_.simulated > 0 && std::isfinite(n.value)) n.text = x.str(accuracy_.digits, std::ios_base::fmtflags(0));
    return n;
  }

  /// Collisions after which the orbit is what it was, moved by a lattice vector or not.
  [[nodiscard]] std::int64_t prime() const {
    const auto n = static_cast<std::size_t>(collisions_);
    const Multi near = std::max(Multi(accuracy_.certain), power_of_ten(-12));
    const auto returns = [&](std::size_t d) {
      for (std::size_t k = 0; k + d < n; ++k) {
        const Turn &a = circuit_.turns[k], &b = circuit_.turns[k + d];
        if (a.who != b.who) return false;
        for (std::size_t c = 0; c < map_.dimension(); ++c) {
          if (abs(Multi(b.velocity[c] - a.velocity[c])) > near * speed_) return false;
          Multi gap = b.position[c] - a.position[c];
          if (const Multi& edge = map_.periods()[c]; edge != 0) gap -= edge * floor(Multi(gap / edge + Multi(1) / 2));
          if (abs(gap) > near * length_) return false;
        }
      }
      return true;
    };
    for (std::size_t d = 1; d < n; ++d)
      if (n % d == 0 && returns(d)) return static_cast<std::int64_t>(d);
    return collisions_;
  }

  [[nodiscard]] PeriodicOrbit result() const {
    PeriodicOrbit o;
    const std::size_t d = map_.dimension();
    o.start = map_.states();
    for (std::size_t b = 0; b < o.start.size(); ++b) {
      o.shift.emplace_back(shift_.begin() + static_cast<std::ptrdiff_t>(b * d), shift_.begin() + static_cast<std::ptrdiff_t>((b + 1) * d));
      for (std::size_t k = 0; k < d; ++k) {
        o.start[b].position[k] = o.start[b].unwrapped_position[k] = shown(state_[b * d + k], length_);
        o.start[b].velocity[k] = shown(state_[size() / 2 + b * d + k], speed_);
        o.start[b].image[k] = 0;
      }
    }
    o.period = shown(period_);
    o.length = shown(length());
    Multis gap = residual(state_, circuit_);
    gap.pop_back();
    for (std::size_t i = 0; i < size(); ++i) gap[i] *= scale(i);
    o.residual = number(largest(gap));
    o.residual.text.clear();
    for (const Turn& t : circuit_.turns) {
      OrbitPoint p{shown(t.time), t.who.kind, t.who.ball, t.who.partner, t.who.feature, {}};
      for (const Multi& x : t.position) p.position.push_back(shown(x, length_));
      o.points.push_back(std::move(p));
    }
    o.prime = prime();
    o.iterations = iterations_;
    o.arithmetic = accuracy_.simulated > 0 ? fmt::format("{} digits", accuracy_.simulated) : "double";
    judge_stability(monodromy(), scaled_flow(state_), scaled_gradient(), accuracy_.certain, o);
    o.trace = shown(multi(o.trace));
    for (Multiplier& m : o.multipliers) {
      if (m.real.text.empty()) continue;
      m.real = shown(multi(m.real));
      m.imaginary = shown(multi(m.imaginary));
    }
    return o;
  }

  /// Speeds change under an acceleration, and between collisions only there.
  [[nodiscard]] Multi length() const {
    if (map_.accelerated()) return Multi(std::numeric_limits<double>::quiet_NaN());
    const std::size_t d = map_.dimension();
    Multi sum(0);
    for (std::size_t b = 0; b < map_.balls(); ++b) {
      Multi since(0), square(0);
      for (std::size_t k = 0; k < d; ++k) square += state_[size() / 2 + b * d + k] * state_[size() / 2 + b * d + k];
      for (const Turn& t : circuit_.turns) {
        const bool partner = t.who.kind == EventKind::ball_ball && t.who.partner == map_.index(b);
        if (t.who.ball != map_.index(b) && !partner) continue;
        sum += sqrt(square) * (t.time - since);
        since = t.time;
        square = partner ? dot(t.partner_velocity, t.partner_velocity) : dot(t.velocity, t.velocity);
      }
      sum += sqrt(square) * (period_ - since);
    }
    return sum;
  }

  Accuracy accuracy_;
  ReturnMap map_;
  std::int64_t collisions_;
  Multis state_;
  Multi period_, length_, speed_, energy_;
  Circuit circuit_;
  std::vector<std::int64_t> shift_;
  int iterations_ = 0;
};

void require(const Scene& scene, std::int64_t collisions) {
  constexpr std::int64_t most = 100'000;
  if (collisions < 1 || collisions > most)
    throw InputError(Problem{scene.file, 0, "a period of " + std::to_string(collisions) + " collisions",
                             "it is a number from 1 to " + std::to_string(most), ""});
}

}  // namespace

std::string_view word(OrbitKind kind) noexcept {
  switch (kind) {
    case OrbitKind::elliptic:
      return "elliptic";
    case OrbitKind::parabolic:
      return "parabolic";
    case OrbitKind::hyperbolic:
      return "hyperbolic";
  }
  return "";
}

PeriodicOrbit refine_orbit(const Scene& scene, std::int64_t collisions, const Precision& precision) {
  require(scene, collisions);
  const int digits = Accuracy::wanted(precision);
  const PrecisionScope<Multi> scope(Accuracy::working(digits));
  try {
    return Refinement(scene, collisions, Accuracy(digits, false))();
  } catch (const InputError&) {
    if (!precision.is_double()) throw;
  }
  return Refinement(scene, collisions, Accuracy(digits, true))();
}

}  // namespace carom
