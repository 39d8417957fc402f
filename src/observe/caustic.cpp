#include "carom/observe/caustic.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

bool concentric(const Scene& scene) {
  const auto same = [&](const WallSpec& w) {
    return w.kind == WallKind::circle && w.centre[0].value == scene.walls.front().centre[0].value &&
           w.centre[1].value == scene.walls.front().centre[1].value;
  };
  return !scene.walls.empty() && std::all_of(scene.walls.begin(), scene.walls.end(), same);
}

bool one_ellipse(const Scene& scene) { return scene.walls.size() == 1 && scene.walls.front().kind == WallKind::ellipse; }

double cross(double x, double y, const std::array<double, 3>& v) { return x * v[1] - y * v[0]; }

}  // namespace

std::string Caustic::refusal(const Scene& scene, const Subject& subject) {
  if (subject.dimension != 2) return "the tables that have one are those of two dimensions";
  if (subject.accelerated()) return "under an acceleration paths are no straight lines";
  if (subject.free > 1 && std::any_of(subject.radius.begin(), subject.radius.end(), [](double r) { return r > 0; }))
    return "balls that hit each other conserve nothing of their own";
  if (concentric(scene) && subject.space == SpaceKind::open) return "";
  if (!one_ellipse(scene) || subject.space != SpaceKind::open)
    return "the walls are neither circles about one centre nor one ellipse";
  if (subject.magnetic != 0) return "in a magnetic field an ellipse conserves nothing";
  for (std::size_t i = 0; i < subject.radius.size(); ++i)
    if (subject.radius[i] > 0) return "only a point conserves it in an ellipse";
  return "";
}

Caustic::Caustic(const Scene& scene, const Subject& subject)
    : ellipse_(one_ellipse(scene)), magnetic_(subject.magnetic), seen_(subject.mass.size()) {
  const WallSpec& wall = scene.walls.front();
  first_ = second_ = {wall.centre[0], wall.centre[1]};
  if (!ellipse_) return;
  const double a = wall.axes[0], b = wall.axes[1], focus = std::sqrt(std::abs((a - b) * (a + b)));
  const double turned = wall.angle.value, c = std::cos(turned), s = std::sin(turned);
  const double x = a >= b ? focus * c : -focus * s, y = a >= b ? focus * s : focus * c;
  first_ = {first_[0] - x, first_[1] - y};
  second_ = {second_[0] + x, second_[1] + y};
}

double Caustic::invariant(const Collision::Party& ball) const {
  const std::array<double, 3>& v = ball.velocity_after;
  const double square = v[0] * v[0] + v[1] * v[1];
  const double x = ball.position[0] - first_[0], y = ball.position[1] - first_[1];
  if (magnetic_ != 0) return std::hypot(x - v[1] / magnetic_, y + v[0] / magnetic_);
  const double about_first = cross(x, y, v);
  if (!ellipse_) return about_first / std::sqrt(square);
  return about_first * cross(ball.position[0] - second_[0], ball.position[1] - second_[1], v) / square;
}

void Caustic::collision(const Collision& c, double, const Subject&) {
  if (c.kind != EventKind::ball_wall) return;
  const double value = invariant(c.ball);
  Seen& seen = seen_[c.ball.number];
  seen.least = seen.count > 0 ? std::min(seen.least, value) : value;
  seen.most = seen.count > 0 ? std::max(seen.most, value) : value;
  seen.sum += value;
  ++seen.count;
}

Estimates Caustic::estimates() const {
  Estimates list;
  double spread = 0, count = 0;
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    const Seen& s = seen_[i];
    list.push_back({seen_.size() == 1 ? "caustic.invariant" : "caustic.invariant[" + std::to_string(i) + "]", s.sum / s.count});
    spread = std::max(spread, s.most - s.least);
    count += s.count;
  }
  list.push_back({"caustic.spread", count > 0 ? spread : std::numeric_limits<double>::quiet_NaN()});
  return list;
}

}  // namespace carom
