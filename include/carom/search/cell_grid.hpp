#pragma once
// Cells wider than the largest ball: a ball can only meet those in its own cell and the cells around it.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "carom/motion/growing_flight.hpp"
#include "carom/predict/event.hpp"
#include "carom/search/near_walls.hpp"
#include "carom/solve/gap.hpp"
#include "carom/world/state.hpp"
#include "carom/world/world.hpp"

namespace carom {

/// How the cells are laid out.
enum class Layout : std::uint8_t { fitted, one_cell };

/// A grid of cells; crossing a boundary is a bookkeeping event of the ball.
///
/// Where a ball is, is an integer: the tile c of the unbounded grid that its path, drawn on from the stored wrapped
/// position, runs through. Tile c and c + n (n cells a period) are the same cell one period apart, so a partner in tile c'
/// of the cell that tile c + d falls into has the image (c + d - c') / n: exact, at any number of periods, in cells of any
/// size. An edge exceeds the largest diameter by `margin`, so that rounding a crossing time can hide no partner; where a
/// period is smaller than that, the neighbourhood reaches over as many cells as it takes.
template <class Real, int D>
class CellGrid {
 public:
  using WorldType = World<Real, D>;
  using EventType = Event<Real, D>;
  using Tile = std::array<std::int64_t, static_cast<std::size_t>(D)>;
  static constexpr const char* name = "cells";
  static constexpr double margin = 0x1p-10;  ///< relative: a thousand million periods of flight round to far less
  static constexpr double growth_room = 0x1p-6;  ///< share by which diameters may grow, at least, before cells are too small

  explicit CellGrid(Layout layout = Layout::fitted) : layout_(layout) {}

  template <class M>
  void reset(const WorldType& world, const M& motion, const Time<Real>& now) {
    lay_out(world, motion, now);
    const std::size_t n = world.balls.size();
    tiles_.assign(n, Tile{});
    seen_.clear();
    next_.assign(n, none);
    previous_.assign(n, none);
    for (std::uint32_t i = 0; i < n; ++i) {
      seen_.push_back(world.details[i].image);
      if (!world.balls[i].alive) continue;
      const Vec<Real, D> x = position_at(motion, world, i, now);
      for (int k = 0; k < D; ++k) tiles_[i][k] = tile_of(x[k], k);
      link(i);
    }
    if (periodic_ && !world.walls.empty())
      near_walls_.reset(world, lower_, edge_, cells_, Real(reach_ / 2), margin);
  }

  /// The state of ball i was written: its path is drawn on from another period, or it has left. A merged ball goes on from
  /// the common centre of mass, which may lie in another tile.
  template <class M>
  void moved(const WorldType& world, const M&, std::uint32_t i) {
    if (!world.balls[i].alive) {
      unlink(i);
      return;
    }
    if (world.law == LawKind::merge) return place_anew(world, i);
    for (int k = 0; k < D; ++k) {
      tiles_[i][k] -= (world.details[i].image[k] - seen_[i][k]) * cells_[k];
      seen_[i][k] = world.details[i].image[k];
    }
  }

  /// False once a ball has grown beyond what the cells were laid out for.
  [[nodiscard]] bool fits(const WorldType&, std::uint32_t, const Real& diameter) const {
    return !(static_cast<double>(diameter) * (1 + margin) > reach_);
  }

  /// When the first of the growing balls has outgrown the cells; `never` if none will.
  [[nodiscard]] Time<Real> outgrown(const WorldType& world) const {
    const double widest = room_ / (1 + margin) / 2;
    Real first = never<Real>();
    for (std::uint32_t i = 0; i < world.balls.size(); ++i)
      if (world.growth.rates[i] > 0)
        first = std::min<Real>(first, (Real(widest) - world.balls[i].radius) / world.growth.rates[i]);
    return after(world.start, first);
  }

  /// When ball i leaves its tile.
  template <class M>
  [[nodiscard]] EventType next_bookkeeping(const WorldType& world, const M& motion, std::uint32_t i,
                                           const Time<Real>& now) const {
    const Ball<Real, D>& ball = world.balls[i];
    EventType first;
    if (ball.fixed || !ball.alive) return first;
    Time<Real> since = ball.time;
    Vec<Real, D> x = ball.position, v = ball.velocity, a = Vec<Real, D>::Zero();
    if constexpr (M::accelerated || M::circular) {
      since = now;
      x = position_at(motion, world, i, now);
      v = velocity_at(motion, world, i, now);
      a = motion.acceleration(motion.phase(ball));
    }
    for (int k = 0; k < D; ++k) {
      for (const int up : {0, 1}) {
        if (bounded_ && tiles_[i][k] == (up != 0 ? cells_[k] - 1 : 0)) continue;  // a cell at the rim has no end
        const Real boundary = lower_[k] + Real(tiles_[i][k] + up) * edge_[k];
        const Real gap = up != 0 ? boundary - x[k] : x[k] - boundary;
        const Real rate = up != 0 ? -v[k] : v[k];
        Real flight;
        if constexpr (M::circular)
          flight = first_fall(motion.line_gap(gap, rate, up != 0 ? Real(-motion.turned(v)[k]) : motion.turned(v)[k]));
        else
          flight = M::accelerated ? first_fall(gap, rate, Real((up != 0 ? -a[k] : a[k]) / 2)) : gap_time(gap, rate);
        if (flight == never<Real>()) continue;
        EventType e;
        e.time = after(since, flight);
        if (e.time.is_never()) continue;
        e.kind = EventKind::bookkeeping;
        e.ball = i;
        e.partner = static_cast<std::uint32_t>(2 * k + up);
        e.stamp = ball.stamp;
        if (first.kind == EventKind::none || precedes(e, first)) first = e;
      }
    }
    return first;
  }

  /// Ball `e.ball` passes into the next tile.
  void cross(const EventType& e) {
    unlink(e.ball);
    tiles_[e.ball][e.partner / 2] += e.partner % 2 != 0 ? 1 : -1;
    link(e.ball);
  }

  /// Calls f(shape, image) for every piece of a wall that ball i may meet in its tile.
  template <class F>
  void for_each_wall(const WorldType& world, std::uint32_t i, F&& f) const {
    if (!periodic_) return world.walls.for_each([&](const auto& shape) { f(shape, Image<D>{}); });
    if (world.walls.empty()) return;
    Image<D> period{};
    Tile cell = tiles_[i];
    for (int k = 0; k < D; ++k) {
      const std::int64_t n = (cell[k] < 0 ? cell[k] - cells_[k] + 1 : cell[k]) / cells_[k];
      period[k] = static_cast<std::int32_t>(n);
    }
    near_walls_.for_each(world, cell_of(cell), period, f);
  }

  template <class F>
  void for_each_partner(const WorldType& world, std::uint32_t i, F&& f) const {
    if (points_) return;
    Tile d;
    for (int k = 0; k < D; ++k) d[k] = -range_[k];
    while (true) {
      in_tile(world, i, d, f);
      int k = 0;
      while (k < D && ++d[k] > range_[k]) {
        d[k] = -range_[k];
        ++k;
      }
      if (k == D) return;
    }
  }

  /// Only the partners that the crossing `e` has brought within reach.
  template <class F>
  void for_each_new_partner(const WorldType& world, const EventType& e, F&& f) const {
    if (points_) return;
    const int axis = static_cast<int>(e.partner / 2);
    Tile d;
    for (int k = 0; k < D; ++k) d[k] = -range_[k];
    d[axis] = e.partner % 2 != 0 ? range_[axis] : -range_[axis];
    while (true) {
      in_tile(world, e.ball, d, f);
      int k = 0;
      while (k < D && (k == axis || ++d[k] > range_[k])) {
        if (k != axis) d[k] = -range_[k];
        ++k;
      }
      if (k == D) return;
    }
  }

  [[nodiscard]] const Tile& cells() const noexcept { return cells_; }

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  template <class M>
  void lay_out(const WorldType& world, const M& motion, const Time<Real>& now) {
    double largest = 0;
    std::size_t alive = 0;
    Vec<Real, D> low = Vec<Real, D>::Zero(), high = Vec<Real, D>::Zero();
    for (std::uint32_t i = 0; i < world.balls.size(); ++i) {
      if (!world.balls[i].alive) continue;
      const Vec<Real, D> x = position_at(motion, world, i, now);
      for (int k = 0; k < D; ++k) {
        low[k] = alive == 0 ? x[k] : std::min<Real>(low[k], x[k]);
        high[k] = alive == 0 ? x[k] : std::max<Real>(high[k], x[k]);
      }
      largest = std::max(largest, 2 * static_cast<double>(radius_at(world, i, now)));
      ++alive;
    }
    if constexpr (GrowingMotion<M>) {
      largest *= 1 + growth_room;
      if (world.space.kind != SpaceKind::open)  // from points
        largest = std::max(largest, growth_room * growth_room * static_cast<double>(world.space.edge.minCoeff()));
    }
    reach_ = largest * (1 + margin);
    points_ = D > 1 && largest == 0 && !GrowingMotion<M>;
    bounded_ = !world.space.periodic();
    periodic_ = world.space.periodic();
    std::array<double, static_cast<std::size_t>(D)> extent{};
    double most = 1;
    for (int k = 0; k < D; ++k) {
      const bool open = world.space.kind == SpaceKind::open;
      lower_[k] = open ? low[k] : world.space.lower[k];
      extent[k] = static_cast<double>(open ? Real(high[k] - low[k]) : world.space.edge[k]);
      most *= std::max(1.0, reach_ > 0 ? std::floor(extent[k] / reach_) : 1e6);
    }
    // No more cells than about two a ball: more cost crossings and memory, and find nothing.
    const double wanted = std::max(2.0 * static_cast<double>(alive), 1.0);
    const double widen = std::max(1.0, std::pow(most / wanted, 1.0 / D));
    std::int64_t total = 1;
    room_ = never<double>();
    for (int k = 0; k < D; ++k) {
      const double fit = reach_ > 0 ? std::floor(extent[k] / (reach_ * widen)) : std::floor(1e6 / widen);
      cells_[k] = layout_ == Layout::one_cell ? 1 : static_cast<std::int64_t>(std::clamp(fit, 1.0, 1e6));
      // In open space the cells at the rim reach to infinity.
      const double edge = extent[k] > 0 ? extent[k] / static_cast<double>(cells_[k]) : std::max(reach_, 1.0);
      edge_[k] = world.space.kind == SpaceKind::open ? Real(std::max(edge, reach_ > 0 ? reach_ : edge))
                                                     : Real(world.space.edge[k] / Real(cells_[k]));
      range_[k] = 1;
      if (periodic_)
        range_[k] = std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(reach_ / static_cast<double>(edge_[k]))));
      total *= cells_[k];
      if (periodic_ || cells_[k] > 1) room_ = std::min(room_, static_cast<double>(edge_[k]) * static_cast<double>(range_[k]));
    }
    if (periodic_ && !world.walls.empty()) room_ = std::min(room_, reach_);
    first_.assign(static_cast<std::size_t>(total), none);
  }

  [[nodiscard]] std::int64_t tile_of(const Real& x, int k) const {
    using std::floor;
    const std::int64_t t = static_cast<std::int64_t>(floor((x - lower_[k]) / edge_[k]));
    return bounded_ ? std::clamp<std::int64_t>(t, 0, cells_[k] - 1) : t;
  }

  [[gnu::noinline]] void place_anew(const WorldType& world, std::uint32_t i) {
    unlink(i);
    for (int k = 0; k < D; ++k) tiles_[i][k] = tile_of(world.balls[i].position[k], k);
    seen_[i] = world.details[i].image;
    link(i);
  }

  [[nodiscard]] std::size_t cell_of(const Tile& tile) const {
    std::size_t cell = 0;
    for (int k = 0; k < D; ++k) {
      std::int64_t c = tile[k];
      if (c < 0 || c >= cells_[k]) {
        c %= cells_[k];
        if (c < 0) c += cells_[k];
      }
      cell = cell * static_cast<std::size_t>(cells_[k]) + static_cast<std::size_t>(c);
    }
    return cell;
  }

  void link(std::uint32_t i) {
    std::uint32_t& head = first_[cell_of(tiles_[i])];
    next_[i] = head;
    previous_[i] = none;
    if (head != none) previous_[head] = i;
    head = i;
  }
  void unlink(std::uint32_t i) {
    if (next_[i] != none) previous_[next_[i]] = previous_[i];
    if (previous_[i] != none) {
      next_[previous_[i]] = next_[i];
    } else {
      first_[cell_of(tiles_[i])] = next_[i];
    }
  }

  /// Everyone in the tile at offset d from that of ball i.
  template <class F>
  void in_tile(const WorldType&, std::uint32_t i, const Tile& d, F& f) const {
    Tile target;
    for (int k = 0; k < D; ++k) {
      target[k] = tiles_[i][k] + d[k];
      if (bounded_ && (target[k] < 0 || target[k] >= cells_[k])) return;
    }
    for (std::uint32_t j = first_[cell_of(target)]; j != none; j = next_[j]) {
      if (j == i) continue;
      Image<D> image{};
      if (periodic_)
        for (int k = 0; k < D; ++k)  // tiles of one cell differ by whole periods
          image[k] = static_cast<std::int32_t>((target[k] - tiles_[j][k]) / cells_[k]);
      f(j, image);
    }
  }

  Layout layout_;
  bool bounded_ = false, periodic_ = false;
  bool points_ = false;  // in a plane or in space points never meet
  double reach_ = 0;  // largest diameter and margin
  double room_ = 0;   // how far the cells that are looked at reach at least
  Vec<Real, D> lower_ = Vec<Real, D>::Zero(), edge_ = Vec<Real, D>::Zero();
  Tile cells_{}, range_{};
  std::vector<Tile> tiles_;                                                  // by ball
  std::vector<std::array<std::int64_t, static_cast<std::size_t>(D)>> seen_;  // images when last told
  std::vector<std::uint32_t> first_;                                         // by cell: a list of balls
  std::vector<std::uint32_t> next_, previous_;
  NearWalls<Real, D> near_walls_;  // of a periodic space
};

}  // namespace carom
