#include "carom/world/placement/lattice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "carom/core/error.hpp"
#include "carom/world/placement/maxwell.hpp"
#include "carom/world/placement/radius.hpp"
#include "rack.hpp"

namespace carom {
namespace {

using Cells = std::array<std::int64_t, 3>;  ///< unit cells along each axis; hexagonal: balls a row, rows

/// A lattice as it fills the region: its shape with neighbours one apart, and by how much each axis is stretched.
struct Filling {
  Cells cells{};
  int along = 0;  ///< hexagonal: the axis along the rows
  std::array<double, 3> stretch{};
  double distortion = std::numeric_limits<double>::infinity();  ///< largest stretch / smallest
};

const char* name_of(LatticeKind kind) {
  switch (kind) {
    case LatticeKind::chain:
      return "chain";
    case LatticeKind::square:
      return "square";
    case LatticeKind::hexagonal:
      return "hexagonal";
    case LatticeKind::cubic:
      return "cubic";
    case LatticeKind::fcc:
      return "fcc";
    case LatticeKind::rack:
      return "rack";
  }
  return "";
}

int dimension_of(LatticeKind kind) {
  return kind == LatticeKind::chain ? 1 : kind == LatticeKind::cubic || kind == LatticeKind::fcc ? 3 : 2;
}

const double half_root_3 = 0.5 * std::sqrt(3.0);
const double half_root_2 = 0.5 * std::sqrt(2.0);

/// Layers of balls along an axis, and how far apart they are when neighbours are one apart.
struct Layers {
  std::int64_t count;
  double spacing;
};

Layers layers(LatticeKind kind, const Filling& f, int axis) {
  if (kind == LatticeKind::fcc) return {2 * f.cells[axis], half_root_2};
  if (kind != LatticeKind::hexagonal) return {f.cells[axis], 1.0};
  if (axis != f.along) return {f.cells[1], half_root_3};
  return f.cells[1] > 1 ? Layers{2 * f.cells[0], 0.5} : Layers{f.cells[0], 1.0};
}

/// Periodic: the layers repeat. Box: half a neighbour distance is left beyond the outer layers.
void set_stretch(LatticeKind kind, const Region& region, Filling& f) {
  double smallest = std::numeric_limits<double>::infinity(), largest = 0.0;
  for (int k = 0; k < region.dimension; ++k) {
    const auto [count, spacing] = layers(kind, f, k);
    const double extent = region.kind == SpaceKind::periodic ? static_cast<double>(count) * spacing
                                                             : static_cast<double>(count - 1) * spacing + 1.0;
    f.stretch[k] = region.length(k) / extent;
    smallest = std::min(smallest, f.stretch[k]);
    largest = std::max(largest, f.stretch[k]);
  }
  f.distortion = largest / smallest;
}

std::vector<std::int64_t> divisors(std::int64_t n) {
  std::vector<std::int64_t> small, large;
  for (std::int64_t d = 1; d * d <= n; ++d) {
    if (n % d != 0) continue;
    small.push_back(d);
    if (d * d != n) large.push_back(n / d);
  }
  small.insert(small.end(), large.rbegin(), large.rend());
  return small;
}

/// The least distorted way to put `count` balls; nothing if every one is distorted beyond `lattice_distortion`.
std::optional<Filling> best_filling(LatticeKind kind, std::int64_t count, const Region& region) {
  const bool fcc = kind == LatticeKind::fcc, hexagonal = kind == LatticeKind::hexagonal;
  if (count < 1 || (fcc && count % 4 != 0)) return std::nullopt;
  const std::int64_t cells = fcc ? count / 4 : count;
  Filling best;
  const auto consider = [&](Filling f) {
    set_stretch(kind, region, f);
    if (f.distortion < best.distortion) best = f;
  };
  for (const std::int64_t a : divisors(cells)) {
    if (region.dimension == 1 && a != cells) continue;
    if (region.dimension < 3) {
      if (hexagonal && region.kind == SpaceKind::periodic && (cells / a) % 2 != 0) continue;
      consider({{a, cells / a, 1}, 0, {}});
      if (hexagonal) consider({{a, cells / a, 1}, 1, {}});
      continue;
    }
    for (const std::int64_t b : divisors(cells / a)) consider({{a, b, cells / a / b}, 0, {}});
  }
  if (best.distortion > lattice_distortion * (1.0 + 0x1p-50)) return std::nullopt;
  return best;
}

/// Twice the largest radius that fits: the smallest neighbour distance or the smallest distance of a face, doubled.
double largest_diameter(LatticeKind kind, const Region& region, const Filling& f) {
  const auto& s = f.stretch;
  double d = *std::min_element(s.begin(), s.begin() + region.dimension);  // along the axes, and the faces of a box
  if (kind == LatticeKind::hexagonal) {
    const double x = 0.5 * s[f.along], y = half_root_3 * s[1 - f.along];
    const bool periodic = region.kind == SpaceKind::periodic;
    d = f.cells[0] > 1 || periodic ? s[f.along] : std::numeric_limits<double>::infinity();
    if (f.cells[1] > 1) d = std::min(d, std::sqrt(x * x + y * y));
    if (f.cells[1] > 2 || (f.cells[1] > 1 && periodic)) d = std::min(d, 2.0 * y);
    if (!periodic) d = std::min({d, s[0], s[1]});
  }
  if (kind == LatticeKind::fcc) {
    // Half a face diagonal: sqrt((s_i^2 + s_j^2) / 2) is at least the smallest stretch, which counts against a box only.
    if (region.kind == SpaceKind::periodic) {
      d = std::numeric_limits<double>::infinity();
      for (int i = 0; i < 3; ++i) {
        d = std::min({d, std::sqrt(0.5 * (s[i] * s[i] + s[(i + 1) % 3] * s[(i + 1) % 3])), s[i] * 2.0 * half_root_2});
      }
    }
  }
  return d;
}

/// Coordinate of layer j along an axis. In a periodic cell the pattern is centred; in a box the outer layers mirror each
/// other.
double layer_position(LatticeKind kind, const Region& region, const Filling& f, int axis, std::int64_t j) {
  const Layers l = layers(kind, f, axis);
  const double first = region.kind == SpaceKind::periodic ? 0.5 * l.spacing : 0.5;
  return region.lower[axis] + f.stretch[axis] * (first + static_cast<double>(j) * l.spacing);
}

PageVector<double> positions(LatticeKind kind, const Region& region, const Filling& f) {
  PageVector<double> x;
  const auto put = [&](std::array<std::int64_t, 3> layer) {
    for (int k = 0; k < region.dimension; ++k) x.push_back(layer_position(kind, region, f, k, layer[k]));
  };
  if (kind == LatticeKind::hexagonal) {
    for (std::int64_t row = 0; row < f.cells[1]; ++row) {
      for (std::int64_t i = 0; i < f.cells[0]; ++i) {
        const std::int64_t along = f.cells[1] > 1 ? 2 * i + row % 2 : i;
        put(f.along == 0 ? Cells{along, row, 0} : Cells{row, along, 0});
      }
    }
    return x;
  }
  const std::int64_t m = kind == LatticeKind::fcc ? 2 : 1;  // fcc: of the layers' crossings, those of even sum
  for (std::int64_t c = 0; c < (region.dimension > 2 ? m * f.cells[2] : 1); ++c) {
    for (std::int64_t b = 0; b < (region.dimension > 1 ? m * f.cells[1] : 1); ++b) {
      for (std::int64_t a = 0; a < m * f.cells[0]; ++a) {
        if (m == 1 || (a + b + c) % 2 == 0) put({a, b, c});
      }
    }
  }
  return x;
}

/// The nearest counts, two below and two above, for which a lattice exists and, with the radius given, has room.
std::string counts_that_fit(const LatticeSpec& spec, const Region& region) {
  const auto fits = [&](std::int64_t count) {
    const auto f = best_filling(spec.kind, count, region);
    if (!f) return false;
    const double r = spec.radius
                         ? spec.radius->value
                         : radius_for_packing(spec.packing_fraction->value, count, region_volume(region), region.dimension);
    return 2.0 * r <= largest_diameter(spec.kind, region, *f) * (1.0 + 0x1p-50);
  };
  std::vector<std::int64_t> found;
  constexpr int reach = 1000;  // counts tried on each side
  int hits = 0;
  for (std::int64_t n = spec.count - 1; n >= 1 && n > spec.count - reach && hits < 2; --n) {
    if (fits(n)) found.insert(found.begin(), n), ++hits;
  }
  hits = 0;
  for (std::int64_t n = spec.count + 1; n < spec.count + reach && hits < 2; ++n) {
    if (fits(n)) found.push_back(n), ++hits;
  }
  if (found.empty()) return "no count nearby fits this space";
  std::string text = "counts nearby that fit: ";
  for (std::size_t i = 0; i < found.size(); ++i) text += fmt::format("{}{}", i == 0 ? "" : ", ", found[i]);
  return text;
}

std::string shape_rule(LatticeKind kind, const Region& region) {
  switch (kind) {
    case LatticeKind::hexagonal:
      return region.kind == SpaceKind::periodic
                 ? "balls a row times an even number of rows, stretched by a factor of 2 at most"
                 : "balls a row times rows, stretched by a factor of 2 at most";
    case LatticeKind::fcc:
      return "4 times the cells along the three axes, stretched by a factor of 2 at most";
    default:
      return "a product of whole numbers along the axes, stretched by a factor of 2 at most";
  }
}

/// What can be said before a lattice is sought.
std::vector<Problem> problems_of(const LatticeSpec& spec, const Region& region) {
  std::vector<Problem> problems;
  const auto add = [&](std::string what, std::string why, std::string hint) {
    problems.push_back({"", spec.where.line, std::move(what), std::move(why), std::move(hint)});
  };
  const int d = dimension_of(spec.kind);
  if (d != region.dimension) {
    add(fmt::format("a {} lattice in {} dimension{}", name_of(spec.kind), region.dimension,
                    region.dimension == 1 ? "" : "s"),
        fmt::format("it needs {}", d), "chain is 1-D, square, hexagonal and rack are 2-D, cubic and fcc are 3-D");
  }
  if (region.kind == SpaceKind::open)
    add("a lattice in an open space", "a lattice fills [space]", "Give [space] a kind, lower and upper");
  if (spec.count < 1) add(fmt::format("count is {}", spec.count), "a lattice needs at least one ball", "");
  if (!spec.radius && !spec.packing_fraction)
    add("neither radius nor packing_fraction is given", "one sets the size of the balls", "");
  if (spec.packing_fraction && !(spec.packing_fraction->value > 0.0)) {
    add(fmt::format("packing_fraction is {}", spec.packing_fraction->value), "it must be above 0", "");
  }
  if (spec.radius && !(spec.radius->value >= 0.0))
    add(fmt::format("radius is {}", spec.radius->value), "it must be 0 or more", "");
  return problems;
}

double resolved_radius(const LatticeSpec& spec, const Region& region) {
  const double volume = region_volume(region);
  if (!spec.radius) return radius_for_packing(spec.packing_fraction->value, spec.count, volume, region.dimension);
  const double r = spec.radius->value;
  if (!spec.packing_fraction) return r;
  const double packing = static_cast<double>(spec.count) * ball_volume(r, region.dimension) / volume;
  // The radius counts, as in resolve_radii: twelve written digits have to agree.
  if (!(std::abs(packing - spec.packing_fraction->value) <= 1e-12 * packing)) {
    throw InputError(Problem{"", spec.where.line,
                             fmt::format("packing_fraction is {}, but {} balls of radius {} fill {} of [space]",
                                         spec.packing_fraction->value, spec.count, r, packing),
                             "both are given and do not agree", "Leave one of the two out"});
  }
  return r;
}

}  // namespace

PlacedBalls place_lattice(const LatticeSpec& spec, const Region& region) {
  if (spec.kind == LatticeKind::rack) return place_rack(spec, region);
  if (auto problems = problems_of(spec, region); !problems.empty()) throw InputError(std::move(problems));

  const auto filling = best_filling(spec.kind, spec.count, region);
  if (!filling) {
    throw InputError(Problem{"", spec.where.line,
                             fmt::format("{} balls do not fit a {} lattice in this space", spec.count, name_of(spec.kind)),
                             shape_rule(spec.kind, region), counts_that_fit(spec, region)});
  }
  const double r = resolved_radius(spec, region), room = largest_diameter(spec.kind, region, *filling);
  const auto packing = [&](double radius) {
    return static_cast<double>(spec.count) * ball_volume(radius, region.dimension) / region_volume(region);
  };
  // Written so that equality, touching balls, passes in spite of the rounding of either side.
  if (2.0 * r > room * (1.0 + 0x1p-50)) {
    throw InputError(Problem{
        "", spec.where.line,
        fmt::format("{} balls of radius {} (packing fraction {:.6g}) overlap on a {} lattice in this space", spec.count, r,
                    packing(r), name_of(spec.kind)),
        fmt::format("this lattice has room for radius {:.12g}, packing fraction {:.12g}", 0.5 * room, packing(0.5 * room)),
        counts_that_fit(spec, region)});
  }

  PlacedBalls placed{r, packing(r), positions(spec.kind, region, *filling), {}, region};
  placed.velocity = maxwell_velocities(
      {spec.count, region.dimension, spec.temperature ? spec.temperature->value : 0.0, spec.mass, spec.seed, 0},
      region.kind);
  return placed;
}

}  // namespace carom
