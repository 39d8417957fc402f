#include "line.hpp"

#include <algorithm>
#include <map>

#include "carom/core/random.hpp"
#include "carom/world/placement/maxwell.hpp"

namespace carom {
namespace {

struct Interval {
  double low, high;
  double free;  ///< what rods have not taken
  std::vector<std::uint32_t> rods;
};

/// The parts of the line between the obstacles. A ring without obstacles is cut at 0; else at the centre of the first
/// obstacle.
std::vector<Interval> intervals(const Crowd<1>& crowd) {
  const double length = crowd.edge[0];
  std::vector<std::pair<double, double>> taken;  // low and high end of each obstacle
  for (std::size_t i = 0; i < crowd.fixed; ++i)
    taken.emplace_back(crowd.x[i][0] - crowd.radius[i], crowd.x[i][0] + crowd.radius[i]);
  std::sort(taken.begin(), taken.end());
  std::vector<Interval> found;
  const auto add = [&](double low, double high) {
    if (high > low) found.push_back({low, high, high - low, {}});
  };
  if (taken.empty()) return {{0.0, length, length, {}}};
  double end = taken.front().second;
  if (!crowd.periodic) add(0.0, taken.front().first);
  for (std::size_t i = 1; i < taken.size(); ++i) {
    add(end, taken[i].first);
    end = std::max(end, taken[i].second);
  }
  add(end, crowd.periodic ? taken.front().first + length : length);
  return found;
}

/// Index of an interval in proportion to the free length; only those with room for `length`. npos: none has.
std::size_t choose(const std::vector<Interval>& all, double length, RandomStream& draw) {
  double total = 0.0;
  std::size_t chosen = all.size();
  for (const Interval& i : all) total += i.free > length ? i.free : 0.0;
  double mark = draw.uniform() * total;
  for (std::size_t i = 0; i < all.size() && mark >= 0.0; ++i) {
    if (!(all[i].free > length)) continue;
    chosen = i;
    mark -= all[i].free;
  }
  return chosen;
}

}  // namespace

Outcome place_on_line(Crowd<1>& crowd, std::uint32_t attempt) {
  const std::size_t movable = crowd.movable();
  RandomStream draw(crowd.source(0).seed, attempt, use_for_order(0));
  std::vector<Interval> all = intervals(crowd);
  for (std::size_t i = 0; i < movable; ++i) {
    const double length = 2.0 * crowd.radius[crowd.fixed + i];
    const std::size_t chosen = choose(all, length, draw);
    if (chosen == all.size()) return {false, i, 0.0};
    all[chosen].free -= length;
    all[chosen].rods.push_back(static_cast<std::uint32_t>(crowd.fixed + i));
  }

  std::vector<std::pair<double, std::uint32_t>> sequence;  // place of each rod
  const double turn = crowd.periodic && crowd.fixed == 0 ? draw.uniform() * crowd.edge[0] : 0.0;
  for (Interval& interval : all) {
    auto& rods = interval.rods;
    for (std::size_t i = rods.size(); i > 1; --i) {
      std::swap(rods[i - 1], rods[static_cast<std::size_t>(draw.uniform() * static_cast<double>(i))]);
    }
    double end = interval.low;  // of the rods side by side, with the rounding of the sum below
    for (const std::uint32_t rod : rods) end += 2.0 * crowd.radius[rod];
    if (!(end < interval.high)) return {false, movable - 1, 0.0};
    std::vector<double> cuts(rods.size());
    for (double& cut : cuts) cut = draw.uniform() * (interval.high - end);
    std::sort(cuts.begin(), cuts.end());
    double taken = interval.low;
    for (std::size_t i = 0; i < rods.size(); ++i) {
      const double r = crowd.radius[rods[i]];
      double x = taken + cuts[i] + r + turn;
      if (crowd.periodic && x >= crowd.edge[0]) x -= crowd.edge[0];
      sequence.emplace_back(x, rods[i]);
      taken += 2.0 * r;
    }
  }
  std::sort(sequence.begin(), sequence.end());
  std::map<std::uint32_t, std::uint32_t> next;  // by entry: the ball that the next rod of it becomes
  for (std::size_t i = movable; i-- > 0;) next[crowd.source(i).entry] = static_cast<std::uint32_t>(crowd.fixed + i);
  for (const auto& [x, rod] : sequence) crowd.x[next[crowd.source(rod - crowd.fixed).entry]++] = {x};
  return {true, movable, 1.0};
}

}  // namespace carom
