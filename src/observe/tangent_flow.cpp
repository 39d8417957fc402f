#include "carom/observe/tangent_flow.hpp"

#include <algorithm>
#include <cmath>

#include "carom/observe/tangent_map.hpp"

namespace carom {

namespace {

template <int D>
using Vector = typename TangentImpact<D>::Vector;

/// scale (a - b)
template <int D>
Vector<D> difference(const Triple& a, const Triple& b, double scale) {
  Vector<D> v;
  for (std::size_t k = 0; k < v.size(); ++k) v[k] = scale * (a[k] - b[k]);
  return v;
}

}  // namespace

TangentFlow::TangentFlow(const Scene& scene, const Subject& subject, std::size_t count, double unit)
    : dimension_(subject.dimension),
      count_(count),
      unit_(unit),
      epoch_length_(subject.epoch_length),
      magnetic_(subject.magnetic),
      acceleration_(subject.acceleration),
      last_(subject.moment) {
  for (std::uint32_t i = 0; i < subject.mass.size(); ++i) {
    const bool fixed = i < scene.balls.size() && scene.balls[i].fixed;
    balls_.push_back({subject.radius[i], subject.mass[i], !fixed});
    mover_.push_back(subject.moves_freely(i) ? since_.size() : std::numeric_limits<std::size_t>::max());
    if (subject.moves_freely(i)) since_.push_back(subject.moment);
  }
  rows_.assign(row_count() * count_, 0.0);
  const auto swings = [](const WallSpec& w) { return w.oscillation.has_value(); };
  if (std::none_of(scene.walls.begin(), scene.walls.end(), swings)) return;
  for (const WallSpec& wall : scene.walls) {
    Swing swing;
    if (wall.oscillation) {
      for (std::size_t k = 0; k < wall.oscillation->amplitude.size(); ++k) swing.amplitude[k] = wall.oscillation->amplitude[k];
      swing.omega = wall.oscillation->omega;
      swing.phase = wall.oscillation->phase;
    }
    swings_.push_back(swing);
  }
}

Triple TangentFlow::wall_acceleration(std::uint32_t wall, double time) const {
  if (wall >= swings_.size() || swings_[wall].omega == 0) return {};
  const Swing& s = swings_[wall];
  Triple a = s.amplitude;
  for (double& component : a) component *= -s.omega * s.omega * std::sin(s.omega * time + s.phase);
  return a;
}

template <int D>
void TangentFlow::fly(std::size_t mover, const Time<double>& now) {
  const double s = elapsed(since_[mover], now) * (epoch_length_ / unit_);
  since_[mover] = now;
  if constexpr (D == 2)
    if (magnetic_ != 0) return carry_round(rows_of(mover), count_, s, magnetic_ * unit_);
  carry_along<D>(rows_of(mover), count_, s);
}

template <int D>
void TangentFlow::impact(const Collision& c) {
  const bool pair = c.kind == EventKind::ball_ball;
  const std::uint32_t i = c.ball.number, j = c.partner.number;
  const std::size_t a = mover_[i], b = pair ? mover_[j] : std::numeric_limits<std::size_t>::max();
  const bool moves_a = a < movers(), moves_b = b < movers();
  if (moves_a) fly<D>(a, last_);
  if (moves_b) fly<D>(b, last_);
  touched_ = {moves_a ? a : b, moves_b ? b : a};
  if (!moves_a && !moves_b) return;

  const auto pull = [&](std::uint32_t ball, const Triple& v) {
    if (!balls_[ball].pulled) return Triple{};
    Triple g = acceleration_;
    g[0] -= magnetic_ * v[1];
    g[1] += magnetic_ * v[0];
    return g;
  };
  const Triple g_a = pull(i, c.ball.velocity_before);
  const Triple g_b = pair ? pull(j, c.partner.velocity_before) : wall_acceleration(j, c.time);

  TangentImpact<D> m;
  const double square = unit_ * unit_;
  m.normal = difference<D>(c.normal, {}, 1);
  m.approach = difference<D>(c.ball.velocity_before, c.partner.velocity_before, unit_);
  m.pull = difference<D>(g_a, g_b, square);
  m.bend = pair ? 1 / (balls_[i].radius + balls_[j].radius) : bend_of_wall(c.curvature, balls_[i].radius);
  m.drop_a = difference<D>(c.ball.velocity_before, c.ball.velocity_after, unit_);
  if (magnetic_ != 0) m.ease_a = difference<D>(g_a, pull(i, c.ball.velocity_after), square);
  const double bounce = 1 + c.restitution, ma = balls_[i].mass;
  m.share_a = moves_a ? bounce : 0.0;
  if (!pair) return carry_through<D>(m, rows_of(a), nullptr, count_);

  m.drop_b = difference<D>(c.partner.velocity_before, c.partner.velocity_after, unit_);
  if (magnetic_ != 0) m.ease_b = difference<D>(g_b, pull(j, c.partner.velocity_after), square);
  const double mb = balls_[j].mass;
  m.share_b = moves_b ? bounce : 0.0;
  if (moves_a && moves_b) {
    m.share_a *= mb / (ma + mb);
    m.share_b *= ma / (ma + mb);
    return carry_through<D>(m, rows_of(a), rows_of(b), count_);
  }
  if (moves_a) return carry_through<D>(m, rows_of(a), nullptr, count_);
  for (std::size_t k = 0; k < m.normal.size(); ++k) {  // b alone: seen from the other side
    m.normal[k] = -m.normal[k];
    m.approach[k] = -m.approach[k];
    m.pull[k] = -m.pull[k];
  }
  m.drop_a = m.drop_b;
  m.ease_a = m.ease_b;
  m.share_a = m.share_b;
  carry_through<D>(m, rows_of(b), nullptr, count_);
}

void TangentFlow::collision(const Collision& c) {
  last_ = {c.epoch, c.offset / epoch_length_};
  if (dimension_ == 2) return impact<2>(c);
  if (dimension_ == 3) return impact<3>(c);
  impact<1>(c);
}

void TangentFlow::advance_to(const Time<double>& now) {
  for (std::size_t m = 0; m < movers(); ++m) {
    if (dimension_ == 2) fly<2>(m, now);
    if (dimension_ == 3) fly<3>(m, now);
    if (dimension_ == 1) fly<1>(m, now);
  }
  last_ = now;
}

double TangentFlow::largest_of_last() const {
  const std::size_t size = 2 * static_cast<std::size_t>(dimension_) * count_;
  double largest = 0;
  for (std::size_t side = 0; side < (touched_[0] == touched_[1] ? 1 : 2); ++side) {
    if (touched_[side] >= movers()) continue;
    const double* row = rows_.data() + touched_[side] * size;
    for (std::size_t k = 0; k < size; ++k) largest = std::max(largest, std::abs(row[k]));
  }
  return largest;
}

}  // namespace carom
