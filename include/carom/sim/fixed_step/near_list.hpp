#pragma once
// The pairs that a step has to look at: those that were near each other when the list was made, kept until balls have
// moved.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "carom/sim/fixed_step/step_state.hpp"
#include "carom/world/near_pairs.hpp"

namespace carom {

/// A list of all pairs within a margin serves as long as no ball has moved by more than half of what the margin has to
/// spare [Verlet1967]. It is made on a grid of cells, O(N), or of all pairs; the order is that of the balls' numbers, and
/// lists of both kinds are made at the same steps, so that what a step finds is the same.
template <int D>
class NearList {
 public:
  struct Pair {
    std::uint32_t i, j;  ///< i < j: a ball does not move relative to its own images
    Image<D> image;      ///< of j, relative to the positions as they are stored
  };
  struct Neighbour {
    std::uint32_t ball;
    Image<D> image;
  };

  explicit NearList(bool every_pair = false) : every_pair_(every_pair) {}

  /// From now on `pairs` holds all whose surfaces are within `within` [length unit]. May wrap the positions: true if it
  /// did.
  bool ensure(StepState<D>& s, double within) {
    double farthest = 0;
    if (from_.size() == s.size()) {
      for (std::uint32_t i = 0; i < s.size(); ++i) {
        const Vec<double, D> d = s.x[i] - from_[i];
        farthest = std::max(farthest, dot<double, D>(d, d));
      }
      if (2 * std::sqrt(farthest) + within <= margin_) return false;
    }
    make(s, within);
    return true;
  }

  /// Makes the list anew. Positions are wrapped.
  void make(StepState<D>& s, double within) {
    s.wrap_all();
    from_ = s.x;
    margin_ = within + spare(s);
    pairs_.clear();
    const auto add = [&](std::uint32_t i, std::uint32_t j, const Image<D>& image) {
      if (i != j && !(s.immovable(i) && s.immovable(j))) pairs_.push_back({i, j, image});
    };
    if (every_pair_) {
      for_each_pair_at_all(s, add);
    } else {
      for_each_near_pair(s.world, s.x, margin_, grid_, [&](std::uint32_t i, std::uint32_t j, const Image<D>& image) {
        const Vec<double, D> r = s.separation(i, j, image);
        const double reach = (s.radius[i] + s.radius[j]) * (1 + 0x1p-20) + margin_;
        if (!(dot<double, D>(r, r) > reach * reach)) add(i, j, image);
      });
      sort();
    }
  }

  /// A ball at x [length unit], of those that `make` saw, can still meet nobody else on a path of the given length.
  [[nodiscard]] bool covers(std::uint32_t i, const Vec<double, D>& x, double path) const {
    const Vec<double, D> d = x - from_[i];
    return 2 * (std::sqrt(dot<double, D>(d, d)) + path) <= margin_;
  }

  [[nodiscard]] const std::vector<Pair>& pairs() const noexcept { return pairs_; }

  /// The same pairs, from the side of each ball. Call `list_neighbours` after the list was made anew.
  void list_neighbours(std::uint32_t balls) {
    first_.assign(balls + 1, 0);
    for (const Pair& p : pairs_) {
      ++first_[p.i + 1];
      ++first_[p.j + 1];
    }
    for (std::uint32_t i = 0; i < balls; ++i) first_[i + 1] += first_[i];
    neighbours_.resize(2 * pairs_.size());
    fill_.assign(first_.begin(), first_.end() - 1);
    for (const Pair& p : pairs_) {
      neighbours_[fill_[p.i]++] = {p.j, p.image};
      neighbours_[fill_[p.j]++] = {p.i, -p.image};
    }
  }
  [[nodiscard]] std::span<const Neighbour> neighbours(std::uint32_t i) const {
    return {neighbours_.data() + first_[i], neighbours_.data() + first_[i + 1]};
  }

 private:
  // What the list may hold beyond the need of this step: some steps' paths, unless a step is as long as a ball is wide.
  [[nodiscard]] static double spare(const StepState<D>& s) {
    const double path = 2 * s.fastest() * s.dt;
    const double widest = s.radius.empty() ? 0 : *std::max_element(s.radius.begin(), s.radius.end());
    return path < widest ? std::min(32 * path, widest) : 0.0;
  }

  void sort() {
    for (auto from = pairs_.begin(); from != pairs_.end();) {
      auto to = from;
      while (to != pairs_.end() && to->i == from->i) ++to;
      std::sort(from, to, [](const Pair& a, const Pair& b) { return a.j != b.j ? a.j < b.j : a.image < b.image; });
      from = to;
    }
  }

  template <class F>
  void for_each_pair_at_all(const StepState<D>& s, F&& add) const {
    double widest = 0;
    for (const double r : s.radius) widest = std::max(widest, r);
    Image<D> most;
    for (int k = 0; k < D; ++k)
      most[k] = s.world.space.periodic()
                    ? static_cast<std::int32_t>(std::floor((2 * widest + margin_) / s.world.space.edge[k])) + 1
                    : 0;
    for (std::uint32_t i = 0; i < s.size(); ++i)
      for (std::uint32_t j = i + 1; j < s.size(); ++j) {
        Image<D> image = -most;
        while (true) {  // in the order of images: the last component turns fastest
          add(i, j, image);
          int k = D - 1;
          while (k >= 0 && ++image[k] > most[k]) {
            image[k] = -most[k];
            --k;
          }
          if (k < 0) break;
        }
      }
  }

  bool every_pair_;
  double margin_ = -1;
  std::vector<Vec<double, D>> from_;  // where the balls were when the list was made
  std::vector<Pair> pairs_;
  std::vector<Neighbour> neighbours_;  // of ball i: first_[i] .. first_[i + 1] - 1
  std::vector<std::uint32_t> first_, fill_;
  detail::PairGrid<D> grid_;
};

}  // namespace carom
