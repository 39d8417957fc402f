#include "rounding_books.hpp"

#include <algorithm>
#include <cmath>

namespace carom::testing {

namespace {

constexpr double u = 0x1p-53, second_order = 1.0 + 0x1p-20;
constexpr double wide_impact = 64 * 15 * u * u;

[[nodiscard]] double length_of(const std::array<double, 3>& v) { return std::hypot(v[0], v[1], v[2]); }

[[nodiscard]] std::array<double, 3> array_of(const std::vector<Number>& x) {
  std::array<double, 3> out{};
  for (std::size_t k = 0; k < x.size(); ++k) out[k] = x[k];
  return out;
}

}  // namespace

RoundingBooks::RoundingBooks(const Scene& scene, const Simulation& simulation)
    : law_(scene.collision.law),
      rests_(scene.collision.regularise == Regularise::rest),
      accelerated_(!scene.motion.acceleration.empty()),
      velocity_roundings_(scene.collision.simultaneous == Simultaneous::symmetric ? 4.0 : 1.0),
      // The flight, the periods, and the place less them; on a wall also the tilt of the acceleration, and setting down;
      // united, also the image of the partner, the offsets of a body's members, and the common centre.
      position_roundings_(law_ != LawKind::restitution ? 12.0
                          : rests_                     ? 8.0
                                                       : 3.0),
      pull_(array_of(scene.motion.acceleration)),
      period_(simulation.periods()),
      pull_size_(length_of(pull_)) {
  for (const BallState& b : simulation.balls()) {
    Ball ball;
    ball.mass = std::isinf(b.mass.value) ? 0.0 : b.mass.value;
    ball.radius = b.radius;
    ball.time = simulation.time();
    ball.speed = ball.fastest = length_of(array_of(b.velocity));
    ball.group = {b.index};
    momentum_at_start_ += ball.mass * ball.speed;
    balls_.push_back(std::move(ball));
  }
}

double RoundingBooks::of_position(const std::array<double, 3>& x, double way) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k) sum += std::abs(pull_[k]) * (std::abs(x[k]) + way + period_[k]);
  return position_roundings_ * sum;
}

// The speed on a parabola is largest at an end; where a wall is left on the way, it may be larger by what the pull gives.
double RoundingBooks::way_since(const Ball& ball, double now, double speed_now) const {
  const double flight = now - ball.time;
  return (std::max(ball.speed, speed_now) + (rests_ ? pull_size_ * flight : 0.0)) * flight;
}

/// `party` goes on from where `kept` is.
void RoundingBooks::write(const Collision& c, const Collision::Party& party, const Collision::Party& kept) {
  const double before = length_of(party.velocity_before), after = length_of(party.velocity_after);
  const std::vector<std::uint32_t> group = balls_[party.number].group;
  const double place_roundings = group.size() > 1 ? 2 : 1;  // a member's place is that of its body, and its offset added
  double mass = 0.0, span = 0.0;  // of a body: no farther from `kept` is any of its members
  if (group.size() > 1)
    for (const std::uint32_t i : group) span += 2 * balls_[i].radius;
  for (const std::uint32_t i : group) {
    Ball& ball = balls_[i];
    const double way = span + way_since(ball, c.time, before);
    mass += ball.mass;
    const double square = velocity_roundings_ * after * after + (accelerated_ ? before * before : 0.0);
    energy_ += u * ball.mass * (square + place_roundings * of_position(kept.position, way)) +
               wide_impact * ball.mass * (before * before + after * after);
    momentum_ += u * velocity_roundings_ * ball.mass * after + wide_impact * ball.mass * (before + after);
    ball.time = c.time;
    ball.speed = after;
    ball.fastest = std::max({ball.fastest, before, after});
  }
  const double sums = static_cast<double>(group.size() - 1);  // of masses
  energy_ += sums * u * mass * (before * before + after * after);
  momentum_ += sums * u * mass * std::max(before, after);
}

void RoundingBooks::unite(const Collision& c) {
  Ball &a = balls_[c.ball.number], &b = balls_[c.partner.number];
  std::vector<std::uint32_t> all = a.group;
  all.insert(all.end(), b.group.begin(), b.group.end());
  double mass = 0.0;
  for (const std::uint32_t i : all) mass += balls_[i].mass;
  // v_a - s_a g may cancel down to the common velocity.
  const double given = length_of(c.ball.velocity_before) + length_of(c.partner.velocity_before);
  const double v = length_of(c.ball.velocity_after);
  energy_ += wide_impact * mass * given * v;
  momentum_ += wide_impact * mass * given;
  if (law_ == LawKind::stick) {
    for (const std::uint32_t i : all) balls_[i].group = all;
    return;
  }
  a.mass = a.mass > 0 && b.mass > 0 ? a.mass + b.mass : 0.0;
  b.mass = 0.0;
  double potential = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
    potential += std::abs(pull_[k] * (c.ball.position[k] + static_cast<double>(c.ball.image[k]) * period_[k]));
  energy_ += u * a.mass * (v * v + potential);
  momentum_ += u * a.mass * v;
}

void RoundingBooks::record(const Collision& c) {
  if (law_ == LawKind::stick && c.kind == EventKind::ball_ball) {
    // Who joins is placed relative to the other: what either has flown is in the rounding of all places.
    double mass = 0.0, way = 0.0;
    for (const auto* party : {&c.ball, &c.partner}) {
      const Ball& ball = balls_[party->number];
      way += way_since(ball, c.time, length_of(party->velocity_before));
      for (const std::uint32_t i : ball.group) mass += balls_[i].mass;
    }
    energy_ += 2 * u * mass * of_position(c.ball.position, way);
  }
  write(c, c.ball, c.ball);
  if (c.kind != EventKind::ball_ball) return;
  write(c, c.partner, law_ == LawKind::merge ? c.ball : c.partner);
  if (law_ != LawKind::restitution) unite(c);
}

double RoundingBooks::energy(const Simulation& simulation, const EnergyBalance& balance) {
  const double now = simulation.time();
  const auto others = static_cast<double>(simulation.counts().other - others_);
  others_ = simulation.counts().other;
  double look =
      2 * u *
      (std::abs(balance.initial) + std::abs(balance.final) + std::abs(balance.dissipated) + std::abs(balance.injected));
  for (const BallState& b : simulation.balls()) {
    Ball& ball = balls_[b.index];
    const double speed = length_of(array_of(b.velocity));
    ball.fastest = std::max(ball.fastest, speed);
    const double position = of_position(array_of(b.position), way_since(ball, now, speed));
    if (accelerated_) look += u * ball.mass * (speed * speed + position);
    energy_ += others * u * ball.mass * (2 * ball.fastest * ball.fastest + position);
    ball.fastest = std::max(speed, ball.speed);
  }
  return second_order * (energy_ + look);
}

double RoundingBooks::momentum(const Simulation& simulation) const {
  double now = 0.0;
  for (const BallState& b : simulation.balls()) now += balls_[b.index].mass * length_of(array_of(b.velocity));
  const double sums = (3 * static_cast<double>(balls_.size()) + 5) * u * u * (momentum_at_start_ + now);
  return second_order * (momentum_ + sums);
}

}  // namespace carom::testing
