#include "view_walls.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

namespace carom::app {

namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr int steps = 180;

Place place(const Json& x) { return {x[0].get<double>(), x[1].get<double>()}; }

std::vector<Place> walk(int n, const std::function<Place(double)>& at) {
  std::vector<Place> points;
  for (int k = 0; k <= n; ++k) points.push_back(at(static_cast<double>(k) / n));
  return points;
}

double series(const Json& wall, double t) {
  double r = 0;
  for (std::size_t k = 0; k < wall["cosines"].size(); ++k) r += wall["cosines"][k].get<double>() * std::cos(static_cast<double>(k) * t);
  for (std::size_t k = 0; k < wall["sines"].size(); ++k) r += wall["sines"][k].get<double>() * std::sin(static_cast<double>(k) * t);
  return r;
}

}  // namespace

std::vector<Place> wall_points(const Json& wall) {
  const std::string kind = wall["kind"];
  if (kind == "segment") return {place(wall["from"]), place(wall["to"])};
  if (kind == "polygon") {
    std::vector<Place> corners;
    for (const Json& x : wall["vertices"]) corners.push_back(place(x));
    corners.push_back(corners.front());
    return corners;
  }
  if (kind == "plane" || !wall.contains("centre")) return {};
  const Place c = place(wall["centre"]);
  const double angle = wall.value("angle", 0.0);
  const auto turned = [&](double x, double y) {
    return Place{c[0] + std::cos(angle) * x - std::sin(angle) * y, c[1] + std::sin(angle) * x + std::cos(angle) * y};
  };
  if (kind == "circle" || kind == "arc") {
    const double r = wall["radius"], from = kind == "arc" ? wall["from_angle"].get<double>() : 0;
    double span = kind == "arc" ? wall["to_angle"].get<double>() - from : turn;
    if (!(span > 0)) span += turn;
    return walk(steps, [&](double u) { return Place{c[0] + r * std::cos(from + u * span), c[1] + r * std::sin(from + u * span)}; });
  }
  if (kind == "ellipse")
    return walk(steps, [&](double u) {
      return turned(wall["axes"][0].get<double>() * std::cos(turn * u), wall["axes"][1].get<double>() * std::sin(turn * u));
    });
  if (kind == "parabola")
    return walk(steps, [&](double u) {
      const double y = (2 * u - 1) * wall["half_width"].get<double>();
      return turned(y * y / (4 * wall["focal_length"].get<double>()), y);
    });
  return walk(2 * steps, [&](double u) {
    const double r = series(wall, turn * u);
    return turned(r * std::cos(turn * u), r * std::sin(turn * u));
  });
}

std::vector<std::vector<Place>> table_outlines(const Json& walls) {
  std::vector<std::vector<Place>> outlines;
  std::vector<Place> chain;
  int table = -1;
  for (const Json& wall : walls) {
    const int of = wall.value("table", -1);
    const bool piece = wall["kind"] == "segment" || wall["kind"] == "arc";
    if (of < 0 || !piece) continue;
    std::vector<Place> points = wall_points(wall);
    if (wall.contains("from")) {  // the ends as they are, not as their angles say
      points.front() = place(wall["from"]);
      points.back() = place(wall["to"]);
    }
    if (of != table || chain.empty() || chain.back() != points.front()) chain.clear();
    table = of;
    chain.insert(chain.end(), points.begin() + (chain.empty() ? 0 : 1), points.end());
    if (chain.size() < 3 || chain.front() != chain.back()) continue;
    outlines.push_back(std::move(chain));
    chain.clear();
  }
  return outlines;
}

std::vector<Place> shifts_into(const Json& space, const std::vector<Place>& points) {
  if (space["kind"] != "periodic" || points.empty()) return {{0, 0}};
  std::array<int, 2> low{}, high{};
  Place edge{};
  for (std::size_t k = 0; k < 2; ++k) {
    const double lower = space["lower"][k], upper = space["upper"][k];
    const auto [least, most] =
        std::minmax_element(points.begin(), points.end(), [k](const Place& a, const Place& b) { return a[k] < b[k]; });
    edge[k] = upper - lower;
    low[k] = static_cast<int>(std::ceil((lower - (*most)[k]) / edge[k]));
    high[k] = static_cast<int>(std::floor((upper - (*least)[k]) / edge[k]));
  }
  std::vector<Place> shifts;
  for (int i = low[0]; i <= high[0]; ++i)
    for (int j = low[1]; j <= high[1]; ++j) shifts.push_back({i * edge[0], j * edge[1]});
  return shifts;
}

}  // namespace carom::app
