#include "carom/write/scene_toml.hpp"

#include <cmath>
#include <map>

#include <fmt/core.h>

#include "carom/world/placement/maxwell.hpp"
#include "carom/write/number_text.hpp"
#include "space_word.hpp"

namespace carom {

namespace {

constexpr std::int64_t collisions_a_ball = 100;

/// A basic string of TOML.
std::string quoted(const std::string& text) {
  std::string s = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') s += '\\';
    s += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return s + '"';
}

/// Whether TOML takes the text for a decimal: a digit before and after the point, no zeros in front.
bool is_toml_decimal(std::string_view s) {
  if (s.starts_with('-')) s.remove_prefix(1);
  const auto digit = [&](std::size_t i) { return i < s.size() && s[i] >= '0' && s[i] <= '9'; };
  if (!digit(0) || (s[0] == '0' && digit(1))) return false;
  const std::size_t point = s.find('.');
  return point == std::string_view::npos || digit(point + 1);
}

std::string toml(const Number& x) {
  if (std::isinf(x.value)) return "\"inf\"";
  return is_toml_decimal(x.text) ? x.text : number_text(x.value);
}

template <class Components>
std::string toml_vector(const Components& components) {
  std::string s = "[";
  for (const auto& x : components) s += (s.size() > 1 ? ", " : "") + toml(Number(x));
  return s + "]";
}

/// Maxwell velocities for balls of each mass.
std::vector<std::vector<Number>> drawn_velocities(const TrajectoryHead& head, const TrajectoryFrame& frame, const SnapshotScene& options) {
  std::map<double, std::vector<std::size_t>> of_mass;
  for (std::size_t i = 0; i < frame.balls.size(); ++i) of_mass[frame.balls[i].mass].push_back(i);
  std::vector<std::vector<Number>> velocities(frame.balls.size());
  std::uint32_t entry = 0;
  for (const auto& [mass, members] : of_mass) {
    const PageVector<double> v = maxwell_velocities({static_cast<std::int64_t>(members.size()), head.dimension,
                                                      options.temperature, mass, options.seed, entry++},
                                                     head.space);
    const auto dimension = static_cast<std::size_t>(head.dimension);
    for (std::size_t m = 0; m < members.size(); ++m)
      for (std::size_t k = 0; k < dimension; ++k) velocities[members[m]].emplace_back(v[m * dimension + k]);
  }
  return velocities;
}

}  // namespace

std::string scene_toml(const TrajectoryHead& head, const TrajectoryFrame& frame, const SnapshotScene& options) {
  const auto dimension = static_cast<std::size_t>(head.dimension);
  std::string s = fmt::format("# {} balls from {}, time {}.\n", frame.balls.size(), options.source, number_text(frame.time));
  s += head.velocities
           ? ""
           : fmt::format("# It has no velocities: they are drawn at k_B T = {} with seed {}.\n", number_text(options.temperature),
                         options.seed);
  s += "# Laws, walls and forces are not in such a file: add them.\n";
  s += fmt::format("title = {}\ndimension = {}\n", quoted(head.title.empty() ? options.source : head.title), head.dimension);
  if (head.space != SpaceKind::open)
    s += fmt::format("\n[space]\nkind = \"{}\"\nlower = {}\nupper = {}\n", space_word(head.space),
                     toml_vector(std::vector<double>(head.lower.begin(), head.lower.begin() + head.dimension)),
                     toml_vector(std::vector<double>(head.upper.begin(), head.upper.begin() + head.dimension)));
  s += fmt::format("\n[run]\nevents = {}\n", collisions_a_ball * static_cast<std::int64_t>(frame.balls.size()));

  const std::vector<std::vector<Number>> drawn =
      head.velocities ? std::vector<std::vector<Number>>() : drawn_velocities(head, frame, options);
  for (std::size_t i = 0; i < frame.balls.size(); ++i) {
    const BallState& b = frame.balls[i];
    s += fmt::format("\n[[ball]]\nposition = {}\nvelocity = {}\nradius = {}\nmass = {}\n",
                     toml_vector(std::vector<Number>(b.position.begin(), b.position.begin() + static_cast<std::ptrdiff_t>(dimension))),
                     toml_vector(drawn.empty() ? b.velocity : drawn[i]), toml(b.radius), toml(b.mass));
  }
  return s;
}

}  // namespace carom
