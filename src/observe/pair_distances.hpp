#pragma once
// The distances of all pairs of points in a periodic cell that are nearer than a range, in time proportional to their number.

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "carom/observe/subject.hpp"

namespace carom {

/// Points lie sorted into cells about half the range wide; every cell is met with half of those around it. Where the
/// period is too short for that, every point is met with every other.
template <int D>
class PairDistances {
 public:
  /// range <= half of the shortest edge, so that of a pair and its images at most one is nearer.
  PairDistances(const Triple& edge, double range) : edge_(edge), range_(range) {
    for (int k = 0; k < D; ++k) {
      count_[k] = static_cast<std::int64_t>(std::fmin(2 * edge[k] / range, 1000.0));
      many_ = many_ && count_[k] > 2 * reach;
    }
    if (many_) make_steps();
  }

  /// Calls f(square of the distance) once for every pair nearer than the range.
  template <class F>
  void each(const std::vector<Triple>& points, F&& f) {
    sort(points);
    const double range_squared = range_ * range_;
    const auto meet = [&](std::size_t i, std::size_t from, std::size_t to, const Triple& shift) {
      std::array<double, D> x;
      for (int k = 0; k < D; ++k) x[k] = x_[k][i] - shift[k];
      for (std::size_t j = from; j < to; ++j) {
        double square = 0;
        for (int k = 0; k < D; ++k) square += (x_[k][j] - x[k]) * (x_[k][j] - x[k]);
        if (square < range_squared) f(square);
      }
    };
    if (!many_) return each_of_few(range_squared, f);
    std::array<std::int64_t, D> home{};
    for (std::size_t c = 0; c + 1 < first_.size(); ++c) {
      for (std::size_t i = first_[c]; i < first_[c + 1]; ++i) meet(i, i + 1, first_[c + 1], {});
      for (const auto& step : steps_) {
        Triple shift{};
        const std::size_t other = neighbour(home, step, shift);
        for (std::size_t i = first_[c]; i < first_[c + 1]; ++i) meet(i, first_[other], first_[other + 1], shift);
      }
      for (int k = 0; k < D && ++home[k] == count_[k]; ++k) home[k] = 0;
    }
  }

 private:
  using Step = std::array<std::int64_t, D>;
  static constexpr std::int64_t reach = 2;

  /// The half of the cells around, those after the middle, that come nearer than the range.
  void make_steps() {
    Step s;
    s.fill(-reach);
    for (bool after = false;;) {
      double nearest = 0;
      bool middle = true;
      for (int k = 0; k < D; ++k) {
        const double gap = static_cast<double>(std::abs(s[k]) > 0 ? std::abs(s[k]) - 1 : 0) * edge_[k];
        nearest += gap * gap / static_cast<double>(count_[k] * count_[k]);
        middle = middle && s[k] == 0;
      }
      if (after && nearest < range_ * range_) steps_.push_back(s);
      after = after || middle;
      int k = 0;
      while (k < D && ++s[k] > reach) s[k++] = -reach;
      if (k == D) return;
    }
  }

  [[nodiscard]] std::size_t neighbour(const Step& home, const Step& step, Triple& shift) const {
    std::size_t cell = 0;
    for (int k = D - 1; k >= 0; --k) {
      std::int64_t c = home[k] + step[k];
      if (c < 0) c += count_[k], shift[k] = -edge_[k];
      if (c >= count_[k]) c -= count_[k], shift[k] = edge_[k];
      cell = cell * static_cast<std::size_t>(count_[k]) + static_cast<std::size_t>(c);
    }
    return cell;
  }

  /// Wraps the points, and puts them in the order of their cells by counting.
  void sort(const std::vector<Triple>& points) {
    std::size_t cells = 1;
    for (int k = 0; k < D && many_; ++k) cells *= static_cast<std::size_t>(count_[k]);
    first_.assign(cells + 1, 0);
    cell_.resize(points.size());
    for (int k = 0; k < D; ++k) x_[k].resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      std::size_t cell = 0;
      for (int k = D - 1; k >= 0 && many_; --k) {
        const double share = wrapped(points[i][k], k) / edge_[k] * static_cast<double>(count_[k]);
        const auto c = std::min(static_cast<std::int64_t>(share), count_[k] - 1);
        cell = cell * static_cast<std::size_t>(count_[k]) + static_cast<std::size_t>(c);
      }
      cell_[i] = static_cast<std::uint32_t>(cell);
      ++first_[cell + 1];
    }
    for (std::size_t c = 0; c < cells; ++c) first_[c + 1] += first_[c];
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::uint32_t to = next[cell_[i]]++;
      for (int k = 0; k < D; ++k) x_[k][to] = wrapped(points[i][k], k);
    }
  }
  [[nodiscard]] double wrapped(double x, int k) const {
    const double y = x - edge_[k] * std::floor(x / edge_[k]);
    return y < edge_[k] && y >= 0 ? y : 0.0;
  }

  template <class F>
  void each_of_few(double range_squared, F&& f) const {
    const std::size_t n = x_[0].size();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 1; j < n; ++j) {
        double square = 0;
        for (int k = 0; k < D; ++k) {
          const double r = std::abs(x_[k][j] - x_[k][i]), nearest = std::min(r, edge_[k] - r);
          square += nearest * nearest;
        }
        if (square < range_squared) f(square);
      }
  }

  Triple edge_;
  double range_;
  bool many_ = true;
  std::array<std::int64_t, D> count_{};
  std::vector<Step> steps_;
  std::array<std::vector<double>, D> x_;
  std::vector<std::uint32_t> first_, cell_;
};

}  // namespace carom
