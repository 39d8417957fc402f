#include "view_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/core.h>

#include "view_paths.hpp"
#include "view_walls.hpp"

namespace carom::app {

namespace {

constexpr double width = 320, height = 200, margin = 14;
constexpr std::array colours{"#e4572e", "#2e86ab", "#f2b134", "#5c9e5f", "#8e5ea2", "#d9709c", "#3aa6a0", "#b5651d"};
constexpr int pieces = 10;  // of a curved flight

/// From the scene to the picture.
class View {
 public:
  View(const Json& scene, const Paths& paths) : D_(scene["dimension"]), start_(paths.start), now_(paths.now) {
    if (scene["space"]["kind"] != "open") {
      corner(scene["space"]["lower"], scene["space"]["upper"]);
    } else {
      for (const Json& w : scene["walls"]) hold_wall(w);
      for (const auto& flights : paths.of)
        for (const Flight& f : flights) hold(project(f.x), std::isnan(f.radius) ? 0 : f.radius);
      for (std::size_t i = 0; i < paths.of.size(); ++i)
        if (!std::isnan(paths.flight(i).radius)) hold(project(paths.flight(i).at(paths.now)), paths.flight(i).radius);
    }
    const double w = std::max(high_[0] - low_[0], 1e-300), h = std::max(high_[1] - low_[1], 1e-300);
    for (const auto& flights : paths.of) largest_ = std::max(largest_, flights.front().radius);
    scale_ = std::min((width - 2 * margin) / w, D_ == 1 ? 24 / largest_ : (height - 2 * margin) / h);
  }

  /// On the plane of the picture, y upwards, and how near it is.
  [[nodiscard]] Point project(const Point& x) const {
    if (D_ < 3) return {x[0], D_ == 1 ? 0 : x[1], 0};
    return {0.82 * x[0] + 0.57 * x[1], 0.9 * x[2] + 0.25 * (0.82 * x[1] - 0.57 * x[0]),
            0.57 * x[0] - 0.82 * x[1] + 0.4 * x[2]};
  }
  [[nodiscard]] Point place(const Point& x, double t) const {
    const Point p = project(x);
    const double y = D_ == 1 ? margin + 24 + (now_ - t) / std::max(now_ - start_, 1e-300) * (height - 2 * margin - 24)
                             : height / 2 - (p[1] - (low_[1] + high_[1]) / 2) * scale_;
    return {width / 2 + (p[0] - (low_[0] + high_[0]) / 2) * scale_, y, p[2]};
  }
  [[nodiscard]] double scale() const { return scale_; }
  [[nodiscard]] int dimension() const { return D_; }

 private:
  void hold(const Point& p, double r) {
    for (std::size_t k = 0; k < 2; ++k) {
      low_[k] = std::min(low_[k], p[k] - r);
      high_[k] = std::max(high_[k], p[k] + r);
    }
  }
  void corner(const Json& lower, const Json& upper) {
    for (unsigned n = 0; n < 8; ++n) {
      Point x{};
      for (std::size_t k = 0; k < lower.size(); ++k) x[k] = (n >> k & 1U) != 0 ? upper[k] : lower[k];
      hold(project(x), 0);
    }
  }
  void hold_wall(const Json& w) {
    if (D_ == 3 && w["kind"] == "circle") {
      Point p{};
      for (std::size_t k = 0; k < 3; ++k) p[k] = w["centre"][k];
      hold(project(p), w["radius"]);
    }
    if (D_ != 2) return;
    for (const Place& x : wall_points(w)) hold({x[0], x[1], 0}, 0);
  }

  int D_;
  double start_, now_, scale_ = 1, largest_ = 1e-300;
  Point low_{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  Point high_{-std::numeric_limits<double>::max(), -std::numeric_limits<double>::max()};
};

class Svg {
 public:
  Svg(const Json& scene, const Paths& paths) : view_(scene, paths), paths_(paths) {
    text_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} "
        "{}\"><style>rect,.floor{{fill:#f9f8f4}}.back,.wall.back{{fill:#eceae3}}.wall.in{{fill:#f9f8f4}}"
        ".wall{{fill:none;stroke:#3c4650;stroke-width:2;stroke-linejoin:round}}.path{{fill:none;stroke-width:1;opacity:.6}}"
        ".ball{{stroke:#0005;stroke-width:.5}}@media(prefers-color-scheme:dark){{rect,.floor,.wall.in{{fill:#161b21}}.back,.wall.back{{"
        "fill:#0c0f13}}"
        ".wall{{stroke:#aab4bf}}}}</style><rect class=\"back\" width=\"{}\" height=\"{}\"/>",
        width, height, width, height);
    draw_space(scene["space"]);
    if (view_.dimension() == 2) draw_walls(scene);
    if (paths.of.size() <= 40)
      for (std::size_t i = 0; i < paths.of.size(); ++i) draw_path(i);
    draw_balls(paths.of.size() > 1 && scene["names"].contains("0") && scene["names"]["0"] == "cue");
    text_ += "</svg>\n";
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  [[nodiscard]] Point at(const Json& x, const Point& drift = {}) const {
    Point p{};
    for (std::size_t k = 0; k < x.size(); ++k) p[k] = x[k].get<double>() + drift[k];
    return view_.place(p, paths_.now);
  }
  /// Where a wall that moves or swings is, from where the scene puts it.
  [[nodiscard]] Point drift_of(const Json& w) const {
    Point d{};
    const Json velocity = w.value("velocity", Json::array());
    for (std::size_t k = 0; k < velocity.size(); ++k) d[k] = velocity[k].get<double>() * (paths_.now - paths_.start);
    if (!w.contains("oscillation")) return d;
    const Json &o = w["oscillation"], &amplitude = o["amplitude"];
    const double swung = std::sin(o["omega"].get<double>() * paths_.now + o["phase"].get<double>());
    for (std::size_t k = 0; k < amplitude.size(); ++k) d[k] += amplitude[k].get<double>() * swung;
    return d;
  }
  void line(const Point& a, const Point& b) {
    text_ += fmt::format("<path class=\"wall\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>", a[0], a[1], b[0], b[1]);
  }

  void draw_space(const Json& space) {
    if (space["kind"] == "open") return;
    const Json &l = space["lower"], &u = space["upper"];
    if (view_.dimension() == 1) {
      const double from = at(l)[0], to = at(u)[0];
      line({from, margin, 0}, {from, height - margin, 0});
      line({to, margin, 0}, {to, height - margin, 0});
    } else if (view_.dimension() == 2) {
      const Point a = at(l), b = at(u);
      text_ += fmt::format("<rect class=\"floor\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>", a[0],
                           b[1], b[0] - a[0], a[1] - b[1]);
      text_ += fmt::format("<path class=\"wall\" {}d=\"M{:.1f} {:.1f}H{:.1f}V{:.1f}H{:.1f}Z\"/>",
                           space["kind"] == "periodic" ? "stroke-dasharray=\"4 4\" " : "", a[0], a[1], b[0], b[1], a[0]);
    } else {
      for (unsigned n = 0; n < 8; ++n)
        for (unsigned k = 0; k < 3; ++k)
          if ((n >> k & 1U) == 0) {
            Json a = l, b = l;
            for (unsigned m = 0; m < 3; ++m) a[m] = b[m] = (n >> m & 1U) != 0 ? u[m] : l[m];
            b[k] = u[k];
            line(at(a), at(b));
          }
    }
  }

  void draw_walls(const Json& scene) {
    const Json& space = scene["space"];
    const bool periodic = space["kind"] == "periodic";
    if (periodic) {
      const Point a = at(space["lower"]), b = at(space["upper"]);
      text_ += fmt::format("<clipPath id=\"cell\"><path d=\"M{:.1f} {:.1f}H{:.1f}V{:.1f}H{:.1f}Z\"/></clipPath><g clip-path=\"url(#cell)\">",
                           a[0], a[1], b[0], b[1], a[0]);
    }
    for (const std::vector<Place>& outline : table_outlines(scene["walls"])) draw_path("floor", "", outline, {0, 0});
    for (const Json& w : scene["walls"]) draw_wall(w, space);
    if (periodic) text_ += "</g>";
  }

  void draw_path(const char* classes, const char* dashes, const std::vector<Place>& points, const Place& shift) {
    text_ += fmt::format("<path class=\"{}\"{} d=\"", classes, dashes);
    char letter = 'M';
    for (const Place& x : points) {
      const Point p = view_.place({x[0] + shift[0], x[1] + shift[1], 0}, paths_.now);
      text_ += fmt::format("{}{:.1f} {:.1f}", letter, p[0], p[1]);
      letter = 'L';
    }
    text_ += "\"/>";
  }

  /// Where balls leave, the line is dashed.
  void draw_wall(const Json& w, const Json& space) {
    if (w["kind"] == "plane") {
      const Point p = at(w["point"], drift_of(w));
      const double nx = w["normal"][0], ny = w["normal"][1], n = std::hypot(nx, ny), far = 1e3 / n;
      return line({p[0] - ny * far, p[1] - nx * far, 0}, {p[0] + ny * far, p[1] + nx * far, 0});
    }
    const std::vector<Place> points = wall_points(w);
    const bool opening = w.value("opening", false);
    const std::string side = opening ? "" : w.value("side", "");
    const char* classes = side == "outside" ? "wall back" : side == "inside" || (w["kind"] == "polygon" && !opening) ? "wall in" : "wall";
    for (const Place& shift : shifts_into(space, points)) {
      const Point drift = drift_of(w);
      const Place moved{shift[0] + drift[0], shift[1] + drift[1]};
      draw_path(classes, opening ? " stroke-dasharray=\"5 4\"" : "", points, moved);
    }
  }

  [[nodiscard]] static const char* colour(std::size_t i, bool cue) {
    return cue && i == 0 ? "#fbf7ea" : colours[i % colours.size()];
  }

  void draw_path(std::size_t i) {
    const std::vector<Flight>& flights = paths_.of[i];
    text_ += fmt::format("<path class=\"path\" stroke=\"{}\" d=\"", colours[i % colours.size()]);
    for (std::size_t n = 0; n < flights.size(); ++n) {
      const Flight& f = flights[n];
      if (std::isnan(f.radius)) break;
      const double until = n + 1 < flights.size() ? flights[n + 1].time : paths_.now;
      const std::vector<double> times = cuts(f, until);
      for (std::size_t p = 0; p + 1 < times.size(); ++p) {
        const Point shift = cell_of(f.at((times[p] + times[p + 1]) / 2));
        for (const double t : {times[p], times[p + 1]}) {
          Point x = f.at(t);
          for (std::size_t k = 0; k < 3; ++k) x[k] -= shift[k];
          const Point at = view_.place(x, t);
          text_ += fmt::format("{}{:.1f} {:.1f}", t == times[p] ? 'M' : 'L', at[0], at[1]);
        }
      }
    }
    text_ += "\"/>";
  }

  /// The whole periods that x is away from the cell.
  [[nodiscard]] Point cell_of(const Point& x) const {
    Point shift{};
    for (std::size_t k = 0; k < 3; ++k)
      if (paths_.period[k] > 0) shift[k] = paths_.period[k] * std::floor((x[k] - paths_.lower[k]) / paths_.period[k]);
    return shift;
  }

  /// The moments between which a flight is drawn as a straight line inside one cell; a curved one in equal pieces.
  [[nodiscard]] std::vector<double> cuts(const Flight& f, double until) const {
    std::vector<double> times{f.time, until};
    const bool curved = f.a != Point{} || f.magnetic != 0;
    const double turn = std::fabs(f.magnetic) * (until - f.time);  // [rad]
    const int parts = f.magnetic != 0 ? 1 + static_cast<int>(std::min(200.0, 4 * turn)) : pieces;
    for (int p = 1; curved && p < parts; ++p) times.push_back(f.time + (until - f.time) * p / parts);
    for (std::size_t k = 0; !curved && k < 3; ++k) {
      if (!(paths_.period[k] > 0) || f.v[k] == 0) continue;
      const double from = (f.x[k] - paths_.lower[k]) / paths_.period[k], by = f.v[k] * (until - f.time) / paths_.period[k];
      const double low = std::ceil(std::min(from, from + by)), high = std::max(from, from + by);
      for (double m = low; m <= high && times.size() < 200; ++m)
        times.push_back(f.time + (m - from) / by * (until - f.time));
    }
    std::sort(times.begin(), times.end());
    return times;
  }

  void draw_balls(bool cue) {
    struct Drawn {
      Point place;
      double radius;
      std::size_t ball;
    };
    std::vector<Drawn> list;
    for (std::size_t i = 0; i < paths_.of.size(); ++i) {
      const Flight& f = paths_.flight(i);
      if (std::isnan(f.radius)) continue;
      Point x = f.at(paths_.now);
      const Point shift = cell_of(x);
      for (std::size_t k = 0; k < 3; ++k) x[k] -= shift[k];
      list.push_back({view_.place(x, paths_.now), std::max(f.radius * view_.scale(), 1.5), i});
    }
    std::stable_sort(list.begin(), list.end(), [](const Drawn& a, const Drawn& b) { return a.place[2] < b.place[2]; });
    for (const Drawn& d : list)
      text_ += fmt::format("<circle class=\"ball\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"{}\"/>", d.place[0],
                           d.place[1], d.radius, colour(d.ball, cue));
  }

  View view_;
  const Paths& paths_;
  std::string text_;
};

}  // namespace

std::string picture_of(const Json& scene, std::string_view start, std::string_view chunk, double end) {
  return Svg(scene, paths_of(scene, start, chunk, end)).text();
}

}  // namespace carom::app
