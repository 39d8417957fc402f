#include "return_map.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "carom/core/error.hpp"
#include "carom/core/rational.hpp"

namespace carom {

namespace {

[[noreturn]] void refuse(const Scene& scene, std::string what, std::string why, std::string hint = {}) {
  throw InputError(Problem{scene.file, 0, std::move(what), std::move(why), std::move(hint)});
}

Multi digits_or(const std::string* text, double x) { return text != nullptr && !text->empty() ? Multi(*text) : Multi(x); }

bool is_at_rest(const WallSpec& w) {
  return !w.oscillation && std::all_of(w.velocity.begin(), w.velocity.end(), [](const Number& v) { return v.value == 0; });
}

}  // namespace

Multi multi(const Number& number) {
  const Rational r = exact(number);
  return Multi(Multi(numerator(r)) / Multi(denominator(r)));
}

Number number(const Multi& x) {
  Number n(static_cast<double>(x));
  n.text = x.str(0, std::ios_base::fmtflags(0));
  return n;
}

bool Circuit::same_sequence(const Circuit& other) const {
  if (turns.size() != other.turns.size()) return false;
  const auto by_ball = [](const Circuit& circuit) {
    std::map<std::uint32_t, std::vector<Encounter>> sequences;
    for (const Turn& t : circuit.turns) {
      sequences[t.who.ball].push_back(t.who);
      if (t.who.kind == EventKind::ball_ball) sequences[t.who.partner].push_back(t.who);
    }
    return sequences;
  };
  return by_ball(*this) == by_ball(other);
}

ReturnMap::ReturnMap(const Scene& scene, int digits)
    : scene_(scene),
      precision_(digits > 0 ? Precision::decimal(digits) : Precision{}),
      dimension_(static_cast<std::size_t>(scene.dimension)),
      magnetic_(scene.motion.magnetic ? multi(*scene.motion.magnetic) : Multi(0)) {
  if (!scene.lattices.empty() || !scene.gases.empty())
    refuse(scene, "the scene has balls on a lattice or of a gas", "an orbit starts from balls that are written out", "Use [[ball]]");
  if (scene.collision.law != LawKind::restitution)
    refuse(scene, "balls that stick or merge", "they do not come back to their start");
  if (!std::all_of(scene.walls.begin(), scene.walls.end(), is_at_rest))
    refuse(scene, "a wall moves", "orbits are looked for among walls at rest");
  scene_.run = {};
  scene_.run.events = 0;
  scene_.observe = {};
  scene_.output = {};
  const Simulation at_start(scene_, precision_);
  for (std::size_t i = 0; i < dimension_; ++i) {
    const bool periodic = scene.space.kind == SpaceKind::periodic;
    periods_.push_back(periodic ? Multi(multi(scene.space.upper[i]) - multi(scene.space.lower[i])) : Multi(0));
    acceleration_.push_back(i < scene.motion.acceleration.size() ? multi(scene.motion.acceleration[i]) : Multi(0));
  }
  for (std::uint32_t i = 0; i < scene.balls.size(); ++i) {
    const BallSpec& b = scene.balls[i];
    if (b.radius_growth.value != 0) refuse(scene, "ball " + std::to_string(i) + " grows", "it does not come back to its size");
    if (b.fixed) continue;
    if (std::isinf(b.mass.value)) {
      const bool rests = std::all_of(b.velocity.begin(), b.velocity.end(), [](const Number& v) { return v.value == 0; });
      if (!rests) refuse(scene, "ball " + std::to_string(i) + " has an infinite mass and moves", "it never turns back");
      continue;
    }
    moving_.push_back(i);
    masses_.push_back(multi(b.mass));
    states_.push_back(at_start.ball(i));
  }
  if (moving_.empty()) refuse(scene, "no ball moves", "an orbit is that of one or more balls");
  start_ = state(at_start);
}

bool ReturnMap::accelerated() const noexcept {
  return std::any_of(acceleration_.begin(), acceleration_.end(), [](const Multi& a) { return a != 0; });
}

Simulation ReturnMap::simulation(const Multis& from) const {
  Scene scene = scene_;
  for (std::size_t b = 0; b < moving_.size(); ++b) {
    BallSpec& ball = scene.balls[moving_[b]];
    ball.velocity.resize(dimension_);
    for (std::size_t k = 0; k < dimension_; ++k) {
      ball.position[k] = number(from[b * dimension_ + k]);
      ball.velocity[k] = number(from[velocities() + b * dimension_ + k]);
    }
  }
  return Simulation(scene, precision_);
}

CollisionSink ReturnMap::recorder(Circuit& circuit) const {
  return [this, &circuit](const Collision& c) {
    // Of a ball that moves and one that does not, the turn is that of the first.
    const bool swapped = std::find(moving_.begin(), moving_.end(), c.ball.number) == moving_.end();
    const Collision::Party &ball = swapped ? c.partner : c.ball, &partner = swapped ? c.ball : c.partner;
    const CollisionDigits::Party* ball_digits = c.digits == nullptr ? nullptr : swapped ? &c.digits->partner : &c.digits->ball;
    const CollisionDigits::Party* partner_digits = c.digits == nullptr ? nullptr : swapped ? &c.digits->ball : &c.digits->partner;
    Turn t;
    t.who = {c.kind, ball.number, partner.number, c.feature};
    t.time = digits_or(c.digits != nullptr ? &c.digits->time : nullptr, c.time);
    for (std::size_t k = 0; k < dimension_; ++k) {
      const Multi x = digits_or(ball_digits != nullptr ? &ball_digits->position[k] : nullptr, ball.position[k]);
      t.position.push_back(x + periods_[k] * Multi(static_cast<double>(ball.image[k])));
      t.velocity.push_back(digits_or(ball_digits != nullptr ? &ball_digits->velocity[k] : nullptr, ball.velocity_after[k]));
      t.partner_velocity.push_back(
          digits_or(partner_digits != nullptr ? &partner_digits->velocity[k] : nullptr, partner.velocity_after[k]));
    }
    circuit.turns.push_back(std::move(t));
  };
}

Multis ReturnMap::state(const Simulation& simulation) const {
  Multis z(2 * velocities());
  for (std::size_t b = 0; b < moving_.size(); ++b) {
    const BallState s = simulation.ball(moving_[b]);
    for (std::size_t k = 0; k < dimension_; ++k) {
      z[b * dimension_ + k] = multi(s.unwrapped_position[k]);
      z[velocities() + b * dimension_ + k] = multi(s.velocity[k]);
    }
  }
  return z;
}

Circuit ReturnMap::through(const Multis& from, std::int64_t collisions) const {
  Circuit circuit;
  Simulation s = simulation(from);
  s.advance(std::nullopt, collisions, recorder(circuit));
  if (s.summary().energy.dissipated.value != 0)
    refuse(scene_, "an impact dissipates energy", "what loses energy does not come back to its start", "Set restitution = 1");
  return circuit;
}

Circuit ReturnMap::after(const Multis& from, const Multi& time) const {
  Circuit circuit;
  Simulation s = simulation(from);
  constexpr std::int64_t enough = 1'000'000;  // a start that runs wild
  const Stop stop = s.advance(number(time), enough, recorder(circuit));
  if (stop == Stop::until || stop == Stop::no_events_left) circuit.end = state(s);
  return circuit;
}

Multis ReturnMap::flow(const Multis& z) const {
  Multis f(z.size());
  const std::size_t half = velocities();
  for (std::size_t i = 0; i < half; ++i) {
    f[i] = z[half + i];
    f[half + i] = acceleration_[i % dimension_];
  }
  if (magnetic_ != 0)
    for (std::size_t b = 0; b < moving_.size(); ++b) {
      f[half + 2 * b] -= magnetic_ * z[half + 2 * b + 1];
      f[half + 2 * b + 1] += magnetic_ * z[half + 2 * b];
    }
  return f;
}

Multi ReturnMap::energy(const Multis& z) const {
  Multi sum(0);
  const std::size_t half = velocities();
  for (std::size_t i = 0; i < half; ++i)
    sum += masses_[i / dimension_] * (z[half + i] * z[half + i] / 2 - acceleration_[i % dimension_] * z[i]);
  return sum;
}

Multis ReturnMap::energy_gradient(const Multis& z) const {
  Multis g(z.size());
  const std::size_t half = velocities();
  for (std::size_t i = 0; i < half; ++i) {
    g[i] = -masses_[i / dimension_] * acceleration_[i % dimension_];
    g[half + i] = masses_[i / dimension_] * z[half + i];
  }
  return g;
}

}  // namespace carom
