#include "wedged.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <Eigen/Dense>

namespace carom::testing {

namespace {

using Point = Eigen::VectorXd;

constexpr double rounding = 1e-13;  // of coordinates of a few units, after some hundred collisions

[[nodiscard]] Point point_of(const std::vector<Number>& x) {
  Point p(static_cast<Eigen::Index>(x.size()));
  for (std::size_t k = 0; k < x.size(); ++k) p[static_cast<Eigen::Index>(k)] = x[k];
  return p;
}

class Wedge {
 public:
  Wedge(const Scene& scene, const Simulation& simulation)
      : scene_(scene), balls_(simulation.balls()), d_(scene.dimension), time_(simulation.time() - scene.run.start) {
    for (const BallState& b : balls_) at_.push_back(point_of(b.position));
  }

  [[nodiscard]] bool holds() {
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      for (std::size_t j = i + 1; j < balls_.size(); ++j) meet_ball(i, j);
      meet_box(i);
      for (const WallSpec& w : scene_.walls) meet_wall(i, w);
    }
    return pressed_ || (!normals_.empty() && least_length() <= rounding);
  }

 private:
  /// The gap between i and j (or a wall) is opened by a motion of i along n, and of j against it.
  void add(std::size_t i, const Point& n, std::ptrdiff_t j = -1) {
    Point row = Point::Zero(static_cast<Eigen::Index>(balls_.size()) * d_);
    const auto put = [&](std::size_t ball, const Point& part) {
      const double m = balls_[ball].mass;
      if (!std::isinf(m)) row.segment(static_cast<Eigen::Index>(ball) * d_, d_) = part / std::sqrt(m);
    };
    put(i, n);
    if (j >= 0) put(static_cast<std::size_t>(j), -n);
    if (row.norm() > 0) normals_.push_back(row.normalized());
  }

  void meet_ball(std::size_t i, std::size_t j) {
    Point r = at_[i] - at_[j];
    if (scene_.space.kind == SpaceKind::periodic)
      for (int k = 0; k < d_; ++k) {
        const double edge =
            scene_.space.upper[static_cast<std::size_t>(k)] - scene_.space.lower[static_cast<std::size_t>(k)];
        r[k] -= edge * std::round(r[k] / edge);
      }
    const double gap = r.norm() - balls_[i].radius - balls_[j].radius;
    if (std::abs(gap) <= rounding && r.norm() > 0) add(i, r.normalized(), static_cast<std::ptrdiff_t>(j));
  }

  void meet(std::size_t i, const Point& away) {
    if (std::abs(away.norm() - balls_[i].radius) <= rounding && away.norm() > 0) add(i, away.normalized());
  }

  void meet_box(std::size_t i) {
    if (scene_.space.kind != SpaceKind::box) return;
    for (int k = 0; k < d_; ++k) {
      const auto c = static_cast<std::size_t>(k);
      const Point up = Point::Unit(d_, k);
      if (std::abs(at_[i][k] - balls_[i].radius - scene_.space.lower[c]) <= rounding) add(i, up);
      if (std::abs(at_[i][k] + balls_[i].radius - scene_.space.upper[c]) <= rounding) add(i, -up);
    }
  }

  void meet_wall(std::size_t i, const WallSpec& w) {
    Point x = at_[i];
    if (!w.velocity.empty()) x -= time_ * point_of(w.velocity);
    switch (w.kind) {
      case WallKind::plane: {
        const Point n = point_of(w.normal).normalized();
        if (std::abs(n.dot(x - point_of(w.point)) - balls_[i].radius) <= rounding) add(i, n);
        break;
      }
      case WallKind::circle: {
        const Point r = x - point_of(w.centre);
        const bool inside = w.side == WallSide::inside;
        const double reach = w.radius + (inside ? -1.0 : 1.0) * balls_[i].radius;
        if (std::abs(r.norm() - reach) > rounding || r.norm() == 0) break;
        add(i, (inside ? -1.0 : 1.0) * r.normalized());
        const Point v = point_of(balls_[i].velocity);
        pressed_ = pressed_ || (inside && v.norm() > 0 && std::abs(r.normalized().dot(v)) <= rounding * v.norm());
        break;
      }
      case WallKind::segment:
        meet_segment(i, x, point_of(w.from), point_of(w.to));
        break;
      case WallKind::polygon:
        for (std::size_t k = 0; k < w.vertices.size(); ++k)
          meet_segment(i, x, point_of(w.vertices[k]), point_of(w.vertices[(k + 1) % w.vertices.size()]));
        break;
      case WallKind::arc:
      case WallKind::ellipse:
      case WallKind::parabola:
      case WallKind::curve:
        break;  // none is drawn
    }
  }

  /// At its nearest point. Where that is an end, and the ball touches the other segment of the joint too, both are met
  /// there.
  void meet_segment(std::size_t i, const Point& x, const Point& from, const Point& to) {
    const Point along = to - from;
    const double s = std::clamp(along.dot(x - from) / along.squaredNorm(), 0.0, 1.0);
    meet(i, x - from - s * along);
  }

  /// The length of the shortest vector in the convex hull of the normals [Wolfe1976].
  [[nodiscard]] double least_length() const {
    const auto n = static_cast<Eigen::Index>(normals_.size());
    Eigen::MatrixXd a(normals_.front().size(), n);
    for (Eigen::Index j = 0; j < n; ++j) a.col(j) = normals_[static_cast<std::size_t>(j)];
    std::vector<Eigen::Index> set{0};
    Eigen::VectorXd mu = Eigen::VectorXd::Ones(1);
    Point p = a.col(0);
    for (int round = 0; round < 1000; ++round) {
      Eigen::Index best = 0;
      const double lowest = (a.transpose() * p).minCoeff(&best);
      if (lowest > p.squaredNorm() - 1e-28 || std::find(set.begin(), set.end(), best) != set.end()) break;
      set.push_back(best);
      mu.conservativeResize(mu.size() + 1);
      mu[mu.size() - 1] = 0.0;
      while (true) {
        const Eigen::VectorXd affine = nearest_affine(a, set);
        if ((affine.array() > 0).all()) {
          mu = affine;
          break;
        }
        double part = 1.0;
        for (Eigen::Index k = 0; k < mu.size(); ++k)
          if (affine[k] <= 0) part = std::min(part, mu[k] / (mu[k] - affine[k]));
        mu += part * (affine - mu);
        drop_smallest(set, mu);
      }
      p = Point::Zero(a.rows());
      for (std::size_t k = 0; k < set.size(); ++k) p += mu[static_cast<Eigen::Index>(k)] * a.col(set[k]);
    }
    return p.norm();
  }

  /// The weights, of sum 1, of the shortest vector in the affine hull of some normals.
  [[nodiscard]] static Eigen::VectorXd nearest_affine(const Eigen::MatrixXd& a, const std::vector<Eigen::Index>& set) {
    const auto n = static_cast<Eigen::Index>(set.size());
    if (n == 1) return Eigen::VectorXd::Ones(1);
    Eigen::MatrixXd apart(a.rows(), n - 1);
    for (Eigen::Index k = 1; k < n; ++k) apart.col(k - 1) = a.col(set[static_cast<std::size_t>(k)]) - a.col(set[0]);
    const Eigen::VectorXd rest = apart.colPivHouseholderQr().solve(-a.col(set[0]));
    Eigen::VectorXd mu(n);
    mu[0] = 1.0 - rest.sum();
    mu.tail(n - 1) = rest;
    return mu;
  }

  static void drop_smallest(std::vector<Eigen::Index>& set, Eigen::VectorXd& mu) {
    Eigen::Index least = 0;
    mu.minCoeff(&least);
    set.erase(set.begin() + least);
    for (Eigen::Index k = least; k + 1 < mu.size(); ++k) mu[k] = mu[k + 1];
    mu.conservativeResize(mu.size() - 1);
  }

  const Scene& scene_;
  std::vector<BallState> balls_;
  int d_;
  double time_;
  std::vector<Point> at_;
  std::vector<Point> normals_;
  bool pressed_ = false;
};

}  // namespace

bool wedged(const Scene& scene, const Simulation& simulation) { return Wedge(scene, simulation).holds(); }

}  // namespace carom::testing
