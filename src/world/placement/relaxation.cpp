#include "relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "carom/core/pages.hpp"
#include "cells.hpp"

namespace carom {
namespace {

constexpr double list_reach = 0.25;  ///< pairs are listed up to 1 + list_reach contact distances
constexpr std::array<double, 3> slacks{0.02, 0.005, 0.0005};
constexpr double step = 1.4;      ///< share of the overlap that one push removes; halves the sweeps against 1
constexpr int patience = 100;     ///< sweeps between two looks at the progress
constexpr double progress = 0.9;  ///< what a look must find left of the overlaps at most

template <int D>
class Relaxation {
 public:
  using Vector = typename Crowd<D>::Vector;

  /// Takes places and radii out of the crowd, and `run` puts them back.
  Relaxation(Crowd<D>& crowd, std::int64_t& budget)
      : crowd_(crowd),
        budget_(budget),
        shift_(image_shifts<D>(crowd.edge)),
        x_(std::move(crowd.x)),
        radius_(std::move(crowd.radius)),
        id_(x_.size()) {
    std::iota(id_.begin(), id_.end(), 0u);
    largest_ = *std::max_element(radius_.begin(), radius_.end());
    level_of_.resize(x_.size());
    std::array<double, 41> widest{};
    std::array<std::size_t, 41> members{};
    for (std::size_t i = 0; i < x_.size(); ++i) {
      const int l = size_class(radius_[i], largest_);
      level_of_[i] = static_cast<std::uint8_t>(l);
      widest[static_cast<std::size_t>(l)] = std::max(widest[static_cast<std::size_t>(l)], radius_[i]);
      ++members[static_cast<std::size_t>(l)];
    }
    for (std::size_t l = 0; l < members.size(); ++l)
      if (members[l] > 0)
        levels_.push_back({static_cast<int>(l), Cells<D>(crowd.edge, crowd.periodic, 2.0 * widest[l], members[l]), widest[l], {}});
  }

  Outcome run() {
    bool done = false;
    for (std::size_t s = 0; s < slacks.size() && !done && budget_ > 0; ++s) done = relax(slacks[s]);
    list_pairs();
    const double reached = done ? 1.0 : smallest_ratio();
    forget_pairs();
    crowd_.x.resize(x_.size());
    for (std::size_t i = 0; i < x_.size(); ++i) crowd_.x[id_[i]] = x_[i];
    crowd_.radius.resize(x_.size());
    for (std::size_t i = 0; i < x_.size(); ++i) crowd_.radius[id_[i]] = radius_[i];
    return {done, crowd_.movable(), reached};
  }

 private:
  struct Level {
    int size_class;
    Cells<D> cells;
    double widest;
    PageVector<std::uint32_t> start;  ///< first ball of each cell
  };

  bool relax(double slack) {
    list_pairs();
    double before = 0.0;
    for (int sweep = 1;; ++sweep) {
      const double overlap = push_all(slack);
      const bool current = moved_little(slack);
      if (overlap == 0.0 && current && smallest_ratio() > 1.0) return true;
      if (!current) list_pairs();
      if (budget_ <= 0) return false;
      if (sweep % patience != 0) continue;
      if (sweep > patience && overlap > progress * before) return false;
      before = overlap;
    }
  }

  /// One sweep; returns the sum of the relative overlaps that it met.
  double push_all(double slack) {
    double overlap = 0.0;
    budget_ -= static_cast<std::int64_t>(partner_.size());
    const double wide = 1.0 + slack;
    for_each_pair([&](std::size_t i, std::size_t j, std::uint32_t image) {
      const Vector d = between(i, j, image);
      const double square = square_of(d), contact = radius_[i] + radius_[j], apart = contact * wide;
      if (square >= apart * apart) return;
      const double distance = std::sqrt(square);
      if (distance <= contact) overlap += 1.0 - distance / contact + 0x1p-50;
      push(i, j, d, distance, step * (apart - distance));
    });
    return overlap;
  }

  void push(std::size_t i, std::size_t j, Vector d, double distance, double depth) {
    if (!(distance > 0.0)) {
      d[(id_[i] + id_[j]) % D] = 1.0;
      distance = 1.0;
    }
    const double mobility_i = mobility(i), mobility_j = mobility(j), total = mobility_i + mobility_j;
    const double back = -depth * (mobility_i / total) / distance, forth = depth * (mobility_j / total) / distance;
    if (back != 0.0) move(i, d, back);
    if (forth != 0.0) move(j, d, forth);
  }

  /// Small balls move more than large ones, and obstacles do not.
  [[nodiscard]] double mobility(std::size_t i) const {
    if (id_[i] < crowd_.fixed) return 0.0;
    double volume = 1.0;
    for (int k = 0; k < D; ++k) volume *= radius_[i] / largest_;
    return 1.0 / volume;
  }

  /// By `factor` d; where a face or wall is in the way, along the axes that are free.
  void move(std::size_t i, const Vector& d, double factor) {
    Vector to = x_[i];
    for (int k = 0; k < D; ++k) to[k] = within(i, k, to[k] + factor * d[k]);
    if (crowd_.clear(to, radius_[i])) {
      x_[i] = to;
      return;
    }
    for (int k = 0; k < D; ++k) {
      Vector along = x_[i];
      along[k] = to[k];
      if (crowd_.clear(along, radius_[i])) x_[i] = along;
    }
  }

  [[nodiscard]] double within(std::size_t i, int k, double y) const {
    if (crowd_.periodic) return y;
    const double r = radius_[i];
    return y < r ? r : y > crowd_.edge[k] - r ? crowd_.edge[k] - r : y;
  }

  [[nodiscard]] Vector between(std::size_t i, std::size_t j, std::uint32_t image) const {
    Vector d{};
    for (int k = 0; k < D; ++k) d[k] = x_[j][k] + shift_[image][k] - x_[i][k];
    return d;
  }
  [[nodiscard]] static double square_of(const Vector& d) {
    double square = 0.0;
    for (int k = 0; k < D; ++k) square += d[k] * d[k];
    return square;
  }

  /// No ball has moved so far that a pair not listed could be within its contact distance.
  [[nodiscard]] bool moved_little(double slack) const {
    for (std::size_t i = 0; i < x_.size(); ++i) {
      double square = 0.0;
      for (int k = 0; k < D; ++k) square += (x_[i][k] - listed_at_[i][k]) * (x_[i][k] - listed_at_[i][k]);
      const double most = (list_reach - slack) * radius_[i];
      if (square > most * most) return false;
    }
    return true;
  }

  /// Smallest distance over contact distance of the listed pairs.
  [[nodiscard]] double smallest_ratio() const {
    double smallest = 1.0 + list_reach;
    for_each_pair([&](std::size_t i, std::size_t j, std::uint32_t image) {
      const double contact = radius_[i] + radius_[j], square = square_of(between(i, j, image));
      if (square < smallest * contact * (smallest * contact)) smallest = std::sqrt(square) / contact;
    });
    return smallest;
  }

  /// Pairs lie ball by ball: those of ball i are the next partners_of_[i] in partner_. Few lie across an edge of the cell,
  /// so their images are apart.
  template <typename F>
  void for_each_pair(F&& f) const {
    std::size_t p = 0, a = 0;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      for (std::uint32_t left = partners_of_[i]; left > 0; --left) {
        const std::uint32_t partner = partner_[p++];
        f(i, partner & ~across, (partner & across) != 0 ? image_[a++] : home_image<D>);
      }
    }
  }
  void forget_pairs() {
    give_back(listed_at_);
    give_back(partners_of_);
    partner_ = PageArray<std::uint32_t>();
    give_back(image_);
  }

  void list_pairs() {
    forget_pairs();
    wrap();
    sort_into_cells();
    listed_at_ = x_;
    partners_of_.reserve(x_.size());
    std::size_t own = 0;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      while (levels_[own].size_class != level_of_[i]) ++own;
      const std::size_t before = partner_.size();
      for (std::size_t l = 0; l <= own; ++l) list_pairs_of(i, levels_[l], l == own);
      partners_of_.push_back(static_cast<std::uint32_t>(partner_.size() - before));
    }
    budget_ -= 4 * static_cast<std::int64_t>(partner_.size());
  }

  void list_pairs_of(std::size_t i, const Level& level, bool own) {
    constexpr double reach = 1.0 + list_reach;
    level.cells.around(x_[i], (radius_[i] + level.widest) * reach, [&](std::size_t first, std::size_t last, int image) {
      const Vector& s = shift_[image];
      std::size_t begin = level.start[first];
      const std::size_t end = level.start[last];
      if (own) begin = std::max(begin, i + 1);
      for (std::size_t j = begin; j < end; ++j) {
        double square = 0.0;
        for (int k = 0; k < D; ++k) {
          const double d = x_[j][k] + s[k] - x_[i][k];
          square += d * d;
        }
        const double range = (radius_[i] + radius_[j]) * reach;
        if (square < range * range && (id_[i] >= crowd_.fixed || id_[j] >= crowd_.fixed)) add_pair(j, image);
      }
      return true;
    });
  }

  void add_pair(std::size_t j, int image) {
    const std::size_t p = partner_.size();
    partner_.resize(p + 1);
    partner_[p] = static_cast<std::uint32_t>(j) | (image == home_image<D> ? 0 : across);
    if (image != home_image<D>) image_.push_back(static_cast<std::uint8_t>(image));
  }

  void wrap() {
    if (!crowd_.periodic) return;
    for (Vector& x : x_) {
      for (int k = 0; k < D; ++k) {
        while (x[k] < 0.0) x[k] += crowd_.edge[k];
        while (x[k] >= crowd_.edge[k]) x[k] -= crowd_.edge[k];
      }
    }
  }

  /// Puts the balls in the order of (size class, cell), by counting.
  void sort_into_cells() {
    PageVector<std::uint32_t> order(x_.size()), cell(x_.size());
    std::uint32_t offset = 0;
    for (Level& level : levels_) {
      level.start.assign(level.cells.size() + 1, 0);
      for (std::size_t i = 0; i < x_.size(); ++i) {
        if (level_of_[i] != level.size_class) continue;
        cell[i] = static_cast<std::uint32_t>(level.cells.of(x_[i]));
        ++level.start[cell[i] + 1];
      }
      level.start[0] = offset;
      for (std::size_t c = 0; c < level.cells.size(); ++c) level.start[c + 1] += level.start[c];
      offset = level.start.back();
      PageVector<std::uint32_t> next(level.start.begin(), level.start.end() - 1);
      for (std::size_t i = 0; i < x_.size(); ++i) {
        if (level_of_[i] == level.size_class) order[next[cell[i]]++] = static_cast<std::uint32_t>(i);
      }
    }
    give_back(cell);
    reorder(x_, order);
    reorder(radius_, order);
    reorder(id_, order);
    reorder(level_of_, order);
  }

  template <typename T>
  static void reorder(PageVector<T>& values, const PageVector<std::uint32_t>& order) {
    PageVector<T> sorted(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) sorted[i] = values[order[i]];
    values.swap(sorted);
  }

  Crowd<D>& crowd_;
  std::int64_t& budget_;
  std::array<Vector, image_codes<D>()> shift_;
  PageVector<Vector> x_, listed_at_;
  PageVector<double> radius_;
  PageVector<std::uint32_t> id_;  ///< their numbers in the crowd
  PageVector<std::uint8_t> level_of_;
  double largest_ = 0.0;
  std::vector<Level> levels_;

  static constexpr std::uint32_t across = std::uint32_t{1} << 31;  ///< of a partner: met in the next image_
  PageVector<std::uint32_t> partners_of_;
  PageArray<std::uint32_t> partner_;
  PageVector<std::uint8_t> image_;
};

}  // namespace

template <int D>
Outcome push_apart(Crowd<D>& crowd, std::int64_t& budget) {
  return Relaxation<D>(crowd, budget).run();
}

template Outcome push_apart(Crowd<1>&, std::int64_t&);
template Outcome push_apart(Crowd<2>&, std::int64_t&);
template Outcome push_apart(Crowd<3>&, std::int64_t&);

}  // namespace carom
