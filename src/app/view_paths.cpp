#include "view_paths.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace carom::app {

namespace {

std::vector<double> doubles(std::string_view bytes, std::size_t from, std::size_t count) {
  std::vector<double> list(count);
  std::memcpy(list.data(), bytes.data() + from, count * sizeof(double));
  return list;
}
std::vector<std::uint32_t> integers(std::string_view bytes, std::size_t from, std::size_t count) {
  std::vector<std::uint32_t> list(count);
  std::memcpy(list.data(), bytes.data() + from, count * sizeof(std::uint32_t));
  return list;
}

/// How many events are drawn: a lone ball's long path, else a crowd's first ones and never all, for merging leaves one
/// ball.
std::size_t shown(std::size_t balls, std::size_t events) {
  if (balls <= 3) return std::min<std::size_t>(events, 60);
  return std::min<std::size_t>(events * 6 / 10 + 1, balls <= 40 ? 60 : 400);
}

/// Balls that grow are drawn as large as they are at the moment of the picture.
void grow(Paths& paths, const Json& scene) {
  if (!scene.contains("radius_growth")) return;
  for (std::size_t i = 0; i < paths.of.size(); ++i) {
    const double at_start = paths.of[i].front().radius;
    paths.of[i].back().radius = at_start + scene["radius_growth"][i].get<double>() * (paths.now - paths.start);
  }
}

}  // namespace

Paths paths_of(const Json& scene, std::string_view start, std::string_view chunk, double end) {
  Paths paths;
  const auto D = scene["dimension"].get<std::size_t>(), N = scene["balls"].get<std::size_t>();
  const std::vector<double> s = doubles(start, 0, N * (2 * D + 3));
  paths.start = paths.now = scene["start"];
  if (scene["space"]["kind"] == "periodic")
    for (std::size_t k = 0; k < D; ++k) {
      paths.lower[k] = scene["space"]["lower"][k];
      paths.period[k] = scene["space"]["upper"][k].get<double>() - paths.lower[k];
    }
  for (std::size_t i = 0; i < N; ++i) {
    Flight f{paths.start, {}, {}, {}, s[2 * N * D + i], scene.value("magnetic", 0.0)};
    for (std::size_t k = 0; k < D; ++k) {
      f.x[k] = s[i * D + k];
      f.v[k] = s[N * D + i * D + k];
      if (k < scene["acceleration"].size() && s[2 * N * D + 2 * N + i] == 0) f.a[k] = scene["acceleration"][k];
    }
    paths.of.push_back({f});
  }
  if (chunk.empty()) {
    paths.now = std::isfinite(end) ? paths.start + (end - paths.start) / 2 : paths.start;
    grow(paths, scene);
    return paths;
  }
  const std::vector<std::uint32_t> head = integers(chunk, 0, 8);
  const std::size_t E = head[2], C = head[3], first = 8 * sizeof(std::uint32_t), f64 = sizeof(double),
                    u32 = sizeof(std::uint32_t);
  const bool told = head[4] != 0;
  const std::vector<double> time = doubles(chunk, first, E), x = doubles(chunk, first + 2 * E * f64, C * D),
                            v = doubles(chunk, first + (2 * E + C * D) * f64, C * D);
  std::size_t at = first + (2 * E + 2 * C * D) * f64;
  const std::vector<double> a = doubles(chunk, at, told ? C * D : 0);
  at += a.size() * f64;
  const std::vector<double> radius = doubles(chunk, at, told ? C : 0);
  at += 2 * radius.size() * f64 + (5 + D) * E * u32 + 3 * E * u32;
  const std::vector<std::uint32_t> changes_end = integers(chunk, at, E), ball = integers(chunk, at + E * u32, C);
  const std::size_t events = shown(N, E);
  for (std::size_t e = 0, c = 0; e < events; ++e)
    for (; c < changes_end[e]; ++c) {
      Flight f = paths.of[ball[c]].back();
      f.time = time[e];
      for (std::size_t k = 0; k < D; ++k) {
        f.x[k] = x[c * D + k];
        f.v[k] = v[c * D + k];
        if (told) f.a[k] = a[c * D + k];
      }
      if (told) f.radius = radius[c];
      paths.of[ball[c]].push_back(f);
    }
  // A little later, when those that met have parted.
  const double last = time[events - 1], next = events < E ? time[events] : std::max(end, last);
  paths.now = last + std::min(0.9 * (next - last), 0.4 * (last - paths.start));
  grow(paths, scene);
  return paths;
}

}  // namespace carom::app
