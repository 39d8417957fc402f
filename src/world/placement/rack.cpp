#include "rack.hpp"

#include <fmt/format.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "carom/core/error.hpp"
#include "carom/world/placement/maxwell.hpp"
#include "carom/world/placement/radius.hpp"

namespace carom {
namespace {

std::vector<Problem> problems_of(const LatticeSpec& spec, const Region& region) {
  std::vector<Problem> problems;
  const auto add = [&](std::string what, std::string why, std::string hint) {
    problems.push_back({"", spec.where.line, std::move(what), std::move(why), std::move(hint)});
  };
  if (region.dimension != 2)
    add(fmt::format("a rack in {} dimensions", region.dimension), "it lies on a table, which has 2", "");
  if (spec.rows < 1 || spec.rows > 10000) add(fmt::format("a rack of {} rows", spec.rows), "1 to 10000 are possible", "");
  const std::int64_t count = std::int64_t{spec.rows} * (std::int64_t{spec.rows} + 1) / 2;
  if (spec.count != 0 && spec.count != count) {
    add(fmt::format("count is {}, but a rack of {} rows has {} balls", spec.count, spec.rows, count), "",
        "Leave count out: it follows from rows");
  }
  if (spec.packing_fraction) add("a rack with a packing_fraction", "its radius and gap set how dense it is", "Give radius");
  if (spec.radius && !(spec.radius->value > 0.0))
    add(fmt::format("radius is {}", spec.radius->value), "it must be above 0", "");
  if (!(spec.gap.value >= 0.0)) add(fmt::format("gap is {}", spec.gap.value), "it must be 0 or more", "");
  if (spec.apex.size() != 2) add(fmt::format("apex has {} components", spec.apex.size()), "it needs 2", "");
  const bool zero = spec.direction.size() == 2 && spec.direction[0].value == 0.0 && spec.direction[1].value == 0.0;
  if ((!spec.direction.empty() && spec.direction.size() != 2) || zero) {
    add("direction of the rack is no vector of 2 components that differs from 0", "it leads from the apex to the last row",
        "");
  }
  return problems;
}

}  // namespace

PlacedBalls place_rack(const LatticeSpec& spec, const Region& region) {
  if (auto problems = problems_of(spec, region); !problems.empty()) throw InputError(std::move(problems));
  using Wide = boost::multiprecision::cpp_bin_float_50;
  const double radius = spec.radius ? spec.radius->value : 0.5;
  const Wide ux = spec.direction.empty() ? 1.0 : spec.direction[0].value,
             uy = spec.direction.empty() ? 0.0 : spec.direction[1].value;
  const Wide length = sqrt(ux * ux + uy * uy), spacing = (2 * Wide(radius) + Wide(spec.gap.value)) / length;
  const Wide row_spacing = spacing * sqrt(Wide(3)) / 2;

  PlacedBalls placed;
  placed.radius = radius;
  placed.region = region;
  for (int row = 0; row < spec.rows; ++row) {
    for (int ball = 0; ball <= row; ++ball) {
      const Wide ahead = row * row_spacing, aside = spacing * (2 * ball - row) / 2;
      placed.position.push_back((spec.apex[0].value + ahead * ux - aside * uy).convert_to<double>());
      placed.position.push_back((spec.apex[1].value + ahead * uy + aside * ux).convert_to<double>());
    }
  }
  const auto count = static_cast<std::int64_t>(placed.position.size() / 2);
  if (region.kind != SpaceKind::open) {
    placed.packing = static_cast<double>(count) * ball_volume(radius, 2) / region_volume(region);
  }
  placed.velocity = maxwell_velocities(
      {count, 2, spec.temperature ? spec.temperature->value : 0.0, spec.mass, spec.seed, 0}, region.kind);
  return placed;
}

}  // namespace carom
