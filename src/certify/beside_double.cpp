#include "beside_double.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "log.hpp"

namespace carom::certify {

namespace {

double length_of(const Vector& v) {
  double square = 0;
  for (const Rational& c : v) square += std::pow(nearest_double(c), 2);
  return std::sqrt(square);
}

double smallest_length(const System& system) {
  double radius = std::numeric_limits<double>::infinity(), edge = radius;
  const auto take = [](double& smallest, double x) {
    if (x > 0) smallest = std::min(smallest, x);
  };
  for (const SystemBall& b : system.balls) take(radius, nearest_double(b.radius));
  for (const Piece& p : system.pieces) take(radius, nearest_double(p.radius));
  if (std::isfinite(radius)) return radius;
  if (system.period)
    for (const Rational& l : *system.period) take(edge, nearest_double(l));
  for (const Piece& p : system.pieces) {
    if (p.kind == PieceKind::edge) take(edge, length_of(p.direction));
    for (const Piece& q : system.pieces)
      if (p.kind == PieceKind::plane && q.kind == PieceKind::plane)
        take(edge, length_of({q.point[0] - p.point[0], q.point[1] - p.point[1], q.point[2] - p.point[2]}));
  }
  for (const SystemBall& a : system.balls)
    for (const SystemBall& b : system.balls)
      if (!std::isfinite(edge)) take(edge, length_of({a.position[0] - b.position[0], a.position[1] - b.position[1], a.position[2] - b.position[2]}));
  return std::isfinite(edge) ? edge : 1.0;
}

std::array<std::int64_t, 3> back(std::array<std::int64_t, 3> period) {
  for (std::int64_t& n : period) n = -n;
  return period;
}

}  // namespace

BesideDouble::BesideDouble(const Scene& scene, const System& system)
    : scene_(scene), simulation_(scene), periods_(simulation_.periods()), waiting_(system.balls.size()) {
  for (const SystemBall& b : system.balls) radii_.push_back(nearest_double(b.radius));
  found_.length = smallest_length(system);
}

bool BesideDouble::add(const Claim& c, const Place& place) {
  if (found_.different) return false;
  if (!ended_) step();
  meet(c.ball, {0, place.time, {c.kind, c.partner, c.feature, c.period}, place.ball, {}}, true);
  if (c.kind == MeetingKind::ball_ball)
    meet(c.partner, {0, place.time, {c.kind, c.ball, c.feature, back(c.period)}, place.partner, {}}, true);
  return !found_.different;
}

/// One more collision of the double run.
void BesideDouble::step() {
  if (scene_.run.events && event_ >= *scene_.run.events) return;
  const std::int64_t before = event_;
  simulation_.advance(scene_.run.until, 1, [&](const Collision& c) {
    ++event_;
    const Claim claim = claim_of(c, radii_[c.ball.number] + (c.kind == EventKind::ball_ball ? radii_[c.partner.number] : 0.0), periods_);
    const auto unwrapped = [&](const Collision::Party& p) {
      std::array<double, 3> x = p.position;
      for (std::size_t k = 0; k < 3; ++k) x[k] += static_cast<double>(p.image[k]) * periods_[k];
      return x;
    };
    meet(claim.ball, {event_, c.time, {claim.kind, claim.partner, claim.feature, claim.period}, unwrapped(c.ball), c.ball.velocity_before}, false);
    if (claim.kind == MeetingKind::ball_ball)
      meet(claim.partner, {event_, c.time, {claim.kind, claim.ball, claim.feature, back(claim.period)}, unwrapped(c.partner), c.partner.velocity_before}, false);
  });
  ended_ = event_ == before;
}

void BesideDouble::meet(std::uint32_t ball, Meeting meeting, bool proven) {
  Waiting& w = waiting_[ball];
  (proven ? w.proven : w.computed).push_back(std::move(meeting));
  if (w.proven.empty() || w.computed.empty() || found_.different) return;
  const Meeting truth = std::move(w.proven.front()), run = std::move(w.computed.front());
  w.proven.pop_front();
  w.computed.pop_front();
  if (truth.with != run.with) {
    found_.different = Mark{run.event, run.time};
    return;
  }
  found_.compared = std::max(found_.compared, run.event);
  // Where the ball of the double run is when the proven one meets.
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k) square += std::pow(run.x[k] + (truth.time - run.time) * run.v[k] - truth.x[k], 2);
  const double error = std::sqrt(square);
  found_.largest_error = std::max(found_.largest_error, error);
  if (!found_.off && error > 0.01 * found_.length) found_.off = Mark{run.event, run.time};
}

}  // namespace carom::certify
