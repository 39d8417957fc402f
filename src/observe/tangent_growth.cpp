#include "carom/observe/tangent_growth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "carom/core/random.hpp"

namespace carom {

namespace {

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector plus(const Vector& a, double s, const Vector& b) { return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]}; }
Vector minus(const Vector& a, const Vector& b) { return plus(a, -1, b); }

constexpr double large = 1e100;  // beyond it all displacements of a run are scaled down together

}  // namespace

TangentGrowth::TangentGrowth(const Scene& scene, const Simulation& start)
    : dimension_(scene.dimension), epoch_length_(start.epoch_length()) {
  for (std::size_t k = 0; k < scene.motion.acceleration.size(); ++k) acceleration_[k] = scene.motion.acceleration[k];
  std::vector<std::uint32_t> moving;
  const std::vector<BallState> states = start.balls();
  const double begin = scene.run.start;
  now_.epoch = static_cast<std::int64_t>(std::floor(begin / epoch_length_));
  now_.offset = begin - static_cast<double>(now_.epoch) * epoch_length_;
  for (const BallState& b : states) {
    BallFacts facts;
    facts.radius = b.radius;
    facts.mass = b.mass;
    facts.finite = std::isfinite(b.mass.value);
    facts.falls = b.index >= scene.balls.size() || !scene.balls[b.index].fixed;
    facts.since = now_;
    if (facts.finite) moving.push_back(b.index);
    balls_.push_back(facts);
  }
  const std::size_t d = static_cast<std::size_t>(dimension_);
  const bool all = moving.size() * d <= most_vectors;
  vectors_ = all ? moving.size() * d : most_vectors;
  displacements_.assign(vectors_ * balls_.size(), {});
  if (all) {
    for (std::size_t m = 0; m < moving.size(); ++m)
      for (std::size_t k = 0; k < d; ++k) at(m * d + k, moving[m]).x[k] = 1.0;
    return;
  }
  for (std::size_t vector = 0; vector < vectors_; ++vector)
    for (const std::uint32_t ball : moving) {
      RandomStream draws(vector, ball);
      for (std::size_t k = 0; k < d; ++k) at(vector, ball).x[k] = 2 * draws.uniform() - 1;
    }
}

double TangentGrowth::elapsed(const Moment& from, const Moment& to) const {
  return static_cast<double>(to.epoch - from.epoch) * epoch_length_ + (to.offset - from.offset);
}

void TangentGrowth::fly(std::uint32_t ball, const Moment& now) {
  const double s = elapsed(balls_[ball].since, now);
  balls_[ball].since = now;
  for (std::size_t vector = 0; vector < vectors_; ++vector) {
    Displacement& d = at(vector, ball);
    d.x = plus(d.x, s, d.v);
  }
}

/// The radius of curvature of the wall that the ball's centre bounces off, or the distance of two balls' centres; 0 for a
/// flat wall, negative for a concave one.
double TangentGrowth::curvature_radius(const Collision& c) const {
  const double radius = balls_[c.ball.number].radius;
  if (c.kind == EventKind::ball_ball) return radius + balls_[c.partner.number].radius;
  return c.curvature == 0 ? 0.0 : 1 / c.curvature + radius;
}

void TangentGrowth::impact(const Collision& c, std::size_t vector) {
  const bool pair = c.kind == EventKind::ball_ball;
  const std::uint32_t i = c.ball.number, j = c.partner.number;
  const Displacement still;
  Displacement& a = at(vector, i);
  const Displacement b = pair ? at(vector, j) : still;
  const Vector& n = c.normal;  // from the partner to the ball
  const Vector u = minus(c.ball.velocity_before, c.partner.velocity_before);
  const double un = dot(u, n);
  if (!(un < 0)) return;  // grazing: the map is singular, and nothing was changed

  const double delay = -dot(n, minus(a.x, b.x)) / un;  // eq. 3
  const double sigma = curvature_radius(c);
  Vector turn{};  // change of the normal, eq. 4
  if (sigma != 0) turn = plus(Vector{}, 1 / sigma, plus(minus(a.x, b.x), delay, u));
  const Vector da = balls_[i].falls ? acceleration_ : Vector{};
  const Vector db = pair && balls_[j].falls ? acceleration_ : Vector{};
  const Vector du = plus(minus(a.v, b.v), delay, minus(da, db));
  const double change = dot(du, n) + dot(u, turn);
  const Vector kick = plus(plus(Vector{}, change, n), un, turn);  // of (u.n) n, eq. 5

  const double ma = balls_[i].mass, mb = pair ? balls_[j].mass : std::numeric_limits<double>::infinity();
  const bool fa = balls_[i].finite, fb = pair && balls_[j].finite;
  const double sa = !fa ? 0.0 : !fb ? 1.0 : mb / (ma + mb), sb = !fb ? 0.0 : !fa ? 1.0 : ma / (ma + mb);
  const auto write = [&](Displacement& d, double share, const Vector& before, const Vector& after) {
    d.x = plus(d.x, delay, minus(before, after));           // eq. 6
    d.v = plus(d.v, -share * (1 + c.restitution), kick);    // eq. 7
  };
  write(a, sa, c.ball.velocity_before, c.ball.velocity_after);
  if (pair) write(at(vector, j), -sb, c.partner.velocity_before, c.partner.velocity_after);
}

void TangentGrowth::collision(const Collision& c) {
  now_ = {c.epoch, c.offset};
  fly(c.ball.number, now_);
  if (c.kind == EventKind::ball_ball) fly(c.partner.number, now_);
  double largest = 0;
  for (std::size_t vector = 0; vector < vectors_; ++vector) {
    impact(c, vector);
    const Displacement& d = at(vector, c.ball.number);
    for (std::size_t k = 0; k < 3; ++k) largest = std::max({largest, std::abs(d.x[k]), std::abs(d.v[k])});
  }
  if (largest > large) rescale();
}

void TangentGrowth::rescale() {
  for (Displacement& d : displacements_)
    for (std::size_t k = 0; k < 3; ++k) {
      d.x[k] /= large;
      d.v[k] /= large;
    }
  scaled_out_ += 100;
}

double TangentGrowth::digits() const {
  double largest = 0;
  for (std::size_t vector = 0; vector < vectors_; ++vector)
    for (std::size_t ball = 0; ball < balls_.size(); ++ball) {
      const Displacement& d = displacements_[vector * balls_.size() + ball];
      const Vector x = plus(d.x, elapsed(balls_[ball].since, now_), d.v);
      largest = std::max(largest, dot(x, x));
    }
  return largest > 0 ? 0.5 * std::log10(largest) + scaled_out_ : 0.0;
}

}  // namespace carom
