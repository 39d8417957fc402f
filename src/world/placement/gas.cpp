#include "carom/world/placement/gas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "carom/core/error.hpp"
#include "carom/world/placement/maxwell.hpp"
#include "carom/world/placement/radius.hpp"
#include "insertion.hpp"
#include "line.hpp"
#include "relaxation.hpp"

namespace carom {
namespace {

constexpr std::int64_t most_balls = 1'000'000'000;

class Problems {
 public:
  void add(const GasSpec& spec, std::string what, std::string why, std::string hint) {
    list_.push_back({"", spec.where.line, std::move(what), std::move(why), std::move(hint)});
  }
  void raise_if_any() {
    if (!list_.empty()) throw InputError(std::move(list_));
  }

 private:
  std::vector<Problem> list_;
};

void check_values(std::span<const GasSpec> specs, Problems& problems) {
  for (const GasSpec& s : specs) {
    if (s.count < 1 || s.count > most_balls)
      problems.add(s, fmt::format("count is {}", s.count), "1 to 1e9 balls are possible", "");
    if (!s.radius && !s.packing_fraction) {
      problems.add(s, "a gas with neither radius nor packing_fraction", "one sets the size of the balls", "");
    }
    if (s.radius && !(s.radius->value >= 0.0 && std::isfinite(s.radius->value))) {
      problems.add(s, fmt::format("radius is {}", s.radius->value), "it must be 0 or more", "");
    }
    if (s.packing_fraction && !(s.packing_fraction->value > 0.0 && s.packing_fraction->value < 1.0)) {
      problems.add(s, fmt::format("packing_fraction is {}", s.packing_fraction->value), "it must be above 0 and below 1",
                   "");
    }
  }
}

/// An open space becomes the periodic cell of the first entry that gives both radius and packing_fraction.
Region resolve_region(std::span<const GasSpec> specs, const Region& region, Problems& problems) {
  if (region.kind != SpaceKind::open) return region;
  for (const GasSpec& s : specs) {
    if (!s.radius || !s.packing_fraction || !(s.radius->value > 0.0)) continue;
    const int d = region.dimension;
    const double edge =
        dimensional_root(static_cast<double>(s.count) * ball_volume(s.radius->value, d) / s.packing_fraction->value, d);
    Region cell{SpaceKind::periodic, d, {}, {}};
    for (int k = 0; k < d; ++k) cell.upper[k] = edge;
    return cell;
  }
  problems.add(specs.front(), "a gas in an open space", "nothing says how large the space is",
               "Give [space] a kind, lower and upper, or the gas both radius and packing_fraction");
  return region;
}

double share(const GasSpec& s, double radius, const Region& region) {
  return static_cast<double>(s.count) * ball_volume(radius, region.dimension) / region_volume(region);
}

std::vector<double> resolve_radii(std::span<const GasSpec> specs, const Region& region, Problems& problems) {
  std::vector<double> radii;
  for (const GasSpec& s : specs) {
    radii.push_back(s.radius
                        ? s.radius->value
                        : radius_for_packing(s.packing_fraction->value, s.count, region_volume(region), region.dimension));
    if (!s.radius || !s.packing_fraction) continue;
    const double packing = share(s, radii.back(), region);
    // The radius counts; the share beside it, computed elsewhere and written to twelve digits, is asked for agreement only.
    if (std::abs(packing - s.packing_fraction->value) <= 1e-12 * packing) continue;
    problems.add(s,
                 fmt::format("packing_fraction is {}, but {} balls of radius {} fill {} of the space",
                             s.packing_fraction->value, s.count, s.radius->value, packing),
                 "both are given and do not agree", "Leave radius, packing_fraction or [space] out");
  }
  return radii;
}

/// Densest packing known of equal balls; 1 for unequal ones.
double densest(std::span<const double> radii, int dimension) {
  if (dimension == 1 || std::adjacent_find(radii.begin(), radii.end(), std::not_equal_to<>()) != radii.end()) return 1.0;
  return dimension == 2 ? std::numbers::pi / (2.0 * std::sqrt(3.0)) : std::numbers::pi / (3.0 * std::sqrt(2.0));
}

/// What no method could place.
void check_room(std::span<const GasSpec> specs, std::span<const double> radii, const Region& region,
                std::span<const Obstacle> obstacles, Problems& problems) {
  double total = 0.0, narrowest = region.length(0);
  for (int k = 1; k < region.dimension; ++k) narrowest = std::min(narrowest, region.length(k));
  for (std::size_t e = 0; e < specs.size(); ++e) {
    total += share(specs[e], radii[e], region);
    if (2.0 * (radii[e] + padding(radii[e], region)) < narrowest) continue;
    problems.add(
        specs[e], fmt::format("balls of radius {:.12g} in a space {:.12g} wide", radii[e], narrowest),
        region.kind == SpaceKind::periodic ? "a ball would touch its own image" : "they do not fit between the faces",
        "Reduce radius or packing_fraction, or take a larger space");
  }
  for (const Obstacle& o : obstacles) {
    if (region.kind != SpaceKind::periodic || 2.0 * (o.radius + padding(o.radius, region)) < narrowest) continue;
    problems.add(specs.front(), fmt::format("a ball of radius {:.12g} is there already", o.radius),
                 fmt::format("it touches its own image in a cell {:.12g} wide", narrowest), "");
    break;
  }
  const double limit = densest(radii, region.dimension);
  if (total < limit) return;
  const double fit = std::floor(static_cast<double>(specs.front().count) * limit / total);
  problems.add(specs.front(), fmt::format("a packing fraction of {:.6g} was asked for in all", total),
               fmt::format("no packing of these balls exceeds {:.6g}", limit),
               specs.size() == 1 && specs.front().radius ? fmt::format("With this radius fewer than {} balls fit", fit)
                                                         : "Reduce packing_fraction, radius or count");
}

template <int D>
Crowd<D> make_crowd(std::span<const GasSpec> specs, std::span<const double> radii, const Region& region,
                    std::span<const Obstacle> obstacles, const ClearOfWalls& clear_of_walls) {
  Crowd<D> crowd;
  crowd.periodic = region.kind == SpaceKind::periodic;
  crowd.clear_of_walls = clear_of_walls;
  for (int k = 0; k < D; ++k) {
    crowd.lower[k] = region.lower[k];
    crowd.edge[k] = region.length(k);
  }
  for (const Obstacle& o : obstacles) {
    auto& x = crowd.x.emplace_back();
    for (int k = 0; k < D; ++k) {
      x[k] = o.position[k] - crowd.lower[k];
      if (crowd.periodic) x[k] -= crowd.edge[k] * std::floor(x[k] / crowd.edge[k]);
    }
    crowd.radius.push_back(o.radius + padding(o.radius, region));
  }
  crowd.fixed = obstacles.size();
  std::vector<std::uint32_t> order(specs.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return radii[a] > radii[b]; });
  std::size_t balls = crowd.fixed;
  for (const GasSpec& spec : specs) balls += static_cast<std::size_t>(spec.count);
  crowd.radius.reserve(balls);
  for (const std::uint32_t e : order) {
    crowd.runs.push_back({crowd.movable(), {specs[e].seed, e, 0}});
    crowd.radius.resize(crowd.size() + static_cast<std::size_t>(specs[e].count), radii[e] + padding(radii[e], region));
  }
  crowd.x.resize(crowd.radius.size());
  return crowd;
}

/// Every ball at the same speed, in the direction it has. One at rest goes along the first axis.
void set_speed(PageVector<double>& v, int dimension, double speed) {
  for (std::size_t i = 0; i < v.size(); i += static_cast<std::size_t>(dimension)) {
    double square = 0.0;
    for (int k = 0; k < dimension; ++k) square += v[i + k] * v[i + k];
    if (square == 0.0) v[i] = square = 1.0;
    for (int k = 0; k < dimension; ++k) v[i + k] *= speed / std::sqrt(square);
  }
}

double packing_of(const Region& region, const PageVector<double>& radius) {
  double volume = 0.0;
  for (const double r : radius) volume += ball_volume(r, region.dimension);
  return volume / region_volume(region);
}

/// The share of their radius at which the balls, where they are now, can be pushed apart: steps of 3 %.
template <int D>
double reachable(Crowd<D>& crowd, double at_least, std::int64_t budget) {
  for (double factor = 0.97; factor > at_least; factor *= 0.97) {
    for (std::size_t i = 0; i < crowd.size(); ++i) crowd.radius[i] *= 0.97;
    std::int64_t share_of_budget = budget;
    if (push_apart(crowd, share_of_budget).done) return factor;
  }
  return at_least;
}

/// Tries until one attempt succeeds or the time is up; says how far it came.
template <int D>
Outcome place(Crowd<D>& crowd, const Region& region) {
  if constexpr (D == 1) {
    if (!crowd.clear_of_walls) {
      Outcome outcome;
      for (std::uint32_t attempt = 0; attempt < 20 && !outcome.done; ++attempt) outcome = place_on_line(crowd, attempt);
      return outcome;
    }
  }
  const double packing = packing_of(region, crowd.radius), target = insertion_packing(D);
  const double scale = packing <= target ? 1.0 : dimensional_root(target / packing, D);
  // In pairs looked at, of some 20 nanoseconds each: a second for few balls, a quarter of a minute for a million.
  const auto n = static_cast<std::int64_t>(crowd.size());
  const std::int64_t effort = 50'000'000 + std::min(5000 * n, 500'000'000 + 500 * n);
  std::int64_t budget = effort;
  double best = 0.0;
  for (std::uint32_t attempt = 0; attempt < 20 && budget > 0; ++attempt) {
    Outcome outcome = insert_randomly(crowd, scale, attempt);
    if (outcome.done && outcome.reached < 1.0) outcome = push_apart(crowd, budget);
    if (outcome.done || outcome.placed < crowd.movable()) return outcome;
    best = std::max(best, outcome.reached);
  }
  return {false, crowd.movable(), reachable(crowd, best, effort / 4)};
}

[[noreturn]] void refuse(std::span<const GasSpec> specs, std::span<const double> radii, const Region& region,
                         std::size_t culprit, const Outcome& outcome, std::int64_t placed_of_culprit) {
  const GasSpec& s = specs[culprit];
  double asked = 0.0;
  for (std::size_t e = 0; e < specs.size(); ++e) asked += share(specs[e], radii[e], region);
  const std::string what =
      fmt::format("{} balls of radius {:.12g} could not be placed without overlap (packing fraction {:.6g}{})", s.count,
                  radii[culprit], asked, specs.size() > 1 ? " with the other gases" : "");
  if (placed_of_culprit < s.count) {
    throw InputError(Problem{
        "", s.where.line, what, fmt::format("only {} found a place", placed_of_culprit),
        placed_of_culprit > 0 ? fmt::format("About {} fit", placed_of_culprit) : "Is there room between walls and balls?"});
  }
  const double reached = dimensional_power(outcome.reached, region.dimension);
  throw InputError(Problem{
      "", s.where.line, what, fmt::format("a packing fraction of {:.6g} was reached", asked * reached),
      s.radius ? fmt::format("About {} balls of this radius fit", std::floor(static_cast<double>(s.count) * reached))
               : fmt::format("A packing_fraction of {:.4g} fits",
                             std::floor(1e4 * share(s, radii[culprit], region) * reached) / 1e4)});
}

template <int D>
std::vector<PlacedBalls> place_in(std::span<const GasSpec> specs, std::span<const double> radii, const Region& region,
                                  std::span<const Obstacle> obstacles, const ClearOfWalls& clear_of_walls) {
  Crowd<D> crowd = make_crowd<D>(specs, radii, region, obstacles, clear_of_walls);
  const Outcome outcome = place(crowd, region);
  if (!outcome.done) {
    // The entry whose ball found no place; else the one that fills most.
    std::size_t culprit = 0;
    for (std::size_t e = 1; e < specs.size(); ++e) {
      if (share(specs[e], radii[e], region) > share(specs[culprit], radii[culprit], region)) culprit = e;
    }
    std::int64_t placed = specs[culprit].count;
    if (outcome.placed < crowd.movable()) {
      culprit = crowd.source(outcome.placed).entry;
      placed = crowd.source(outcome.placed).index;
    }
    refuse(specs, radii, region, culprit, outcome, placed);
  }
  std::vector<PlacedBalls> all;
  for (std::size_t e = 0; e < specs.size(); ++e) {
    all.push_back({radii[e], share(specs[e], radii[e], region), {}, {}, region});
    all.back().position.resize(static_cast<std::size_t>(specs[e].count) * D);
    all.back().velocity = maxwell_velocities(
        {specs[e].count, D, specs[e].speed ? 1.0 : specs[e].temperature.value, specs[e].mass, specs[e].seed,
         static_cast<std::uint32_t>(e)},
        region.kind);
    if (specs[e].speed) set_speed(all.back().velocity, D, specs[e].speed->value);
  }
  for (std::size_t i = 0; i < crowd.movable(); ++i) {
    const auto source = crowd.source(i);
    for (int k = 0; k < D; ++k) {
      double x = region.lower[k] + crowd.x[crowd.fixed + i][k];
      if (crowd.periodic && x >= region.upper[k]) x = region.lower[k];
      all[source.entry].position[std::size_t{source.index} * D + k] = x;
    }
  }
  return all;
}

}  // namespace

std::vector<PlacedBalls> place_gases(std::span<const GasSpec> specs, const Region& region,
                                     std::span<const Obstacle> obstacles, const ClearOfWalls& clear_of_walls) {
  if (specs.empty()) return {};
  Problems problems;
  check_values(specs, problems);
  problems.raise_if_any();
  const Region space = resolve_region(specs, region, problems);
  problems.raise_if_any();
  const std::vector<double> radii = resolve_radii(specs, space, problems);
  problems.raise_if_any();
  check_room(specs, radii, space, obstacles, problems);
  problems.raise_if_any();
  switch (space.dimension) {
    case 1:
      return place_in<1>(specs, radii, space, obstacles, clear_of_walls);
    case 2:
      return place_in<2>(specs, radii, space, obstacles, clear_of_walls);
    default:
      return place_in<3>(specs, radii, space, obstacles, clear_of_walls);
  }
}

}  // namespace carom
