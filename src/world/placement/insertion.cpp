#include "insertion.hpp"

#include <algorithm>

#include "carom/core/random.hpp"
#include "carom/world/placement/maxwell.hpp"
#include "cells.hpp"

namespace carom {
namespace {

/// Linked lists of balls in cells, one set of cells a class of sizes.
template <int D>
class Lists {
 public:
  using Vector = typename Crowd<D>::Vector;

  explicit Lists(const Crowd<D>& crowd) : crowd_(crowd), shift_(image_shifts<D>(crowd.edge)), next_(crowd.size(), no_ball) {
    largest_ = *std::max_element(crowd.radius.begin(), crowd.radius.end());
    std::vector<std::size_t> members(41);
    std::vector<double> widest(41);
    for (const double r : crowd.radius) {
      const int l = size_class(r, largest_);
      ++members[l];
      widest[l] = std::max(widest[l], r);
    }
    for (int l = 0; l <= 40; ++l) {
      const Cells<D> cells(crowd.edge, crowd.periodic, members[l] ? 2.0 * widest[l] : crowd.edge[0], members[l]);
      levels_.push_back({cells, PageVector<std::uint32_t>(members[l] ? cells.size() : 0, no_ball), widest[l], 0});
    }
  }

  void add(std::uint32_t ball) {
    Level& level = levels_[size_class(crowd_.radius[ball], largest_)];
    std::uint32_t& head = level.head[level.cells.of(crowd_.x[ball])];
    next_[ball] = head;
    head = ball;
    ++level.balls;
  }

  /// Does a ball of radius r at x stay clear of all added, every radius times `scale`?
  [[nodiscard]] bool free(const Vector& x, double r, double scale) const {
    for (const Level& level : levels_) {
      if (level.balls == 0) continue;
      const bool clear =
          level.cells.around(x, scale * (r + level.widest), [&](std::size_t first, std::size_t last, int image) {
            const Vector& s = shift_[image];
            for (std::size_t cell = first; cell < last; ++cell) {
              for (std::uint32_t j = level.head[cell]; j != no_ball; j = next_[j]) {
                double square = 0.0;
                for (int k = 0; k < D; ++k) {
                  const double d = crowd_.x[j][k] + s[k] - x[k];
                  square += d * d;
                }
                const double contact = scale * (r + crowd_.radius[j]);
                if (square <= contact * contact) return false;
              }
            }
            return true;
          });
      if (!clear) return false;
    }
    return true;
  }

 private:
  struct Level {
    Cells<D> cells;
    PageVector<std::uint32_t> head;
    double widest;
    std::size_t balls;
  };

  const Crowd<D>& crowd_;
  std::array<Vector, image_codes<D>()> shift_;
  PageVector<std::uint32_t> next_;
  double largest_ = 0.0;
  std::vector<Level> levels_;
};

template <int D>
typename Crowd<D>::Vector random_place(const Crowd<D>& crowd, double r, RandomStream& draw) {
  typename Crowd<D>::Vector x{};
  for (int k = 0; k < D; ++k) {
    const double u = draw.uniform();
    x[k] = crowd.periodic ? u * crowd.edge[k] : r + u * (crowd.edge[k] - 2.0 * r);
  }
  return x;
}

}  // namespace

template <int D>
Outcome insert_randomly(Crowd<D>& crowd, double scale, std::uint32_t attempt) {
  // Tries of one ball at one scale; and of all balls, which bounds the time.
  constexpr int tries_a_ball = 1000;
  std::int64_t budget = 20'000'000 + 100 * static_cast<std::int64_t>(crowd.size());
  Lists<D> lists(crowd);
  for (std::uint32_t i = 0; i < crowd.fixed; ++i) lists.add(i);
  for (std::uint32_t i = static_cast<std::uint32_t>(crowd.fixed); i < crowd.size(); ++i) {
    const auto source = crowd.source(i - crowd.fixed);
    const double r = crowd.radius[i];
    RandomStream draw(source.seed, source.index, use_for_position(source.entry, attempt));
    bool found = false, clear_once = false;
    for (int tries = 0; !found && budget > 0; --budget) {
      const auto x = random_place(crowd, r, draw);
      if (crowd.clear(x, r)) {
        clear_once = true;
        found = lists.free(x, r, scale);
        crowd.x[i] = x;
      }
      if (!found && ++tries % tries_a_ball == 0) {
        if (clear_once) scale *= 0.9;  // the balls before fit this one too
        if (!clear_once && tries >= 1000 * tries_a_ball) break;
      }
    }
    if (!found) return {false, i - crowd.fixed, scale};
    lists.add(i);
  }
  return {true, crowd.size() - crowd.fixed, scale};
}

template Outcome insert_randomly(Crowd<1>&, double, std::uint32_t);
template Outcome insert_randomly(Crowd<2>&, double, std::uint32_t);
template Outcome insert_randomly(Crowd<3>&, double, std::uint32_t);

}  // namespace carom
