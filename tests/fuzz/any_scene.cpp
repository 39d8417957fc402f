#include "any_scene.hpp"

#include <cmath>
#include <initializer_list>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "carom/core/random.hpp"

namespace carom::testing {

namespace {

using Point = std::vector<double>;

enum class Kind { grid, smooth, extreme };

class Writer {
 public:
  explicit Writer(std::uint64_t number) : dice_(number, 0, 77) {}

  std::string write() {
    dimension_ = 1 + below(3);
    kind_ = one_of({Kind::grid, Kind::grid, Kind::grid, Kind::smooth, Kind::smooth, Kind::extreme});
    line("title = \"any scene\"\ndimension = {}", dimension_);
    write_space();
    write_motion();
    write_collision();
    write_walls();
    write_balls();
    if (chance(0.3)) line("[engine]\nsearch = \"{}\"", one_of({"all_pairs", "cells"}));
    line("[run]\nuntil = {}", until());
    return std::move(text_);
  }

 private:
  template <class... Args>
  void line(fmt::format_string<Args...> format, Args&&... args) {
    text_ += fmt::format(format, std::forward<Args>(args)...);
    text_ += '\n';
  }

  // Draws.
  [[nodiscard]] int below(int n) { return static_cast<int>(dice_.uniform() * n); }
  [[nodiscard]] bool chance(double p) { return dice_.uniform() < p; }
  [[nodiscard]] double between(double low, double high) { return low + (high - low) * dice_.uniform(); }
  template <class T>
  [[nodiscard]] T one_of(std::initializer_list<T> values) {
    return values.begin()[below(static_cast<int>(values.size()))];
  }
  /// A coordinate in the box: on halves, or anywhere.
  [[nodiscard]] double coordinate() { return kind_ == Kind::grid ? 0.5 * below(2 * side + 1) : between(0.0, side); }
  [[nodiscard]] double restitution() { return one_of({1.0, 1.0, 1.0, 0.5, 0.9, 0.0, dice_.uniform()}); }

  [[nodiscard]] static std::string text_of(const Point& x) { return fmt::format("[{}]", fmt::join(x, ", ")); }
  [[nodiscard]] Point filled(double value) const { return Point(static_cast<std::size_t>(dimension_), value); }

  void write_space() {
    const int choice = below(6);
    boxed_ = choice < 3;
    periodic_ = choice == 3 || choice == 4;
    if (!boxed_ && !periodic_) return;
    line("[space]\nkind = \"{}\"\nlower = {}\nupper = {}", boxed_ ? "box" : "periodic", text_of(filled(0.0)),
         text_of(filled(side)));
    if (boxed_ && chance(0.2)) line("restitution = {}", restitution());
  }

  void write_motion() {
    if (!chance(0.25)) return;
    Point g = filled(0.0);
    g.back() = one_of({-1.0, -1.0, -9.81, 0.25});
    if (chance(0.2))
      for (double& x : g) x = between(-1.0, 1.0);
    accelerated_ = true;
    line("[motion]\nacceleration = {}", text_of(g));
  }

  /// Laws, what regularises them, and the rule for simultaneous contacts.
  void write_collision() {
    const std::string_view law =
        one_of<std::string_view>({"restitution", "restitution", "restitution", "restitution", "restitution", "stick", "merge"});
    line("[collision]\nlaw = \"{}\"", law);
    const double e = restitution();
    line("restitution = {}", e);
    if (law != "restitution") return;
    if (chance(0.2)) line("contact_time = {}", one_of({0.001, 0.125, 1.0}));
    const double remedy = dice_.uniform();
    if (remedy < 0.25) {
      line("regularise = \"rest\"");
    } else {
      if (remedy < 0.4 && e > 0) line("regularise = \"viscoelastic\"\nreference_speed = {}", one_of({0.5, 1.0}));
      if (chance(0.35)) line("simultaneous = \"symmetric\"");
    }
  }

  void write_walls() {
    const int count = below(3);
    for (int i = 0; i < count; ++i) {
      if (dimension_ == 1) {
        if (!chance(0.3)) continue;
        line("[[wall]]\nkind = \"plane\"\npoint = [{}]\nnormal = [{}]", chance(0.5) ? -1.0 : 0.0, 1.0);
      } else if (dimension_ == 2 && chance(0.7)) {
        write_flat_wall();
      } else {
        write_round_wall();
      }
      if (chance(0.2)) line("restitution = {}", restitution());
    }
  }

  void write_flat_wall() {
    const double x = coordinate(), y = coordinate();
    switch (below(3)) {
      case 0:
        line("[[wall]]\nkind = \"segment\"\nfrom = [{}, {}]\nto = [{}, {}]", x, y, coordinate(), coordinate());
        break;
      case 1:
        line("[[wall]]\nkind = \"polygon\"\nvertices = [[{}, {}], [{}, {}], [{}, {}]]", x, y, x + 2.0, y, x, y + 2.0);
        break;
      default:
        line("[[wall]]\nkind = \"plane\"\npoint = [0, {}]\nnormal = [{}, 1]", kind_ == Kind::grid ? 0.0 : between(0.0, 1.0),
             kind_ == Kind::grid ? one_of({0.0, 1.0, 0.5}) : between(0.0, 1.0));
        if (chance(0.2)) line("velocity = [0, {}]", one_of({0.25, -0.25}));
    }
  }

  void write_round_wall() {
    if (chance(0.4)) {
      line("[[wall]]\nkind = \"circle\"\ncentre = {}\nradius = {}\nside = \"inside\"", text_of(filled(side / 2.0)),
           one_of({4.0, 5.0, 8.0}));
      return;
    }
    Point centre;
    for (int k = 0; k < dimension_; ++k) centre.push_back(coordinate());
    line("[[wall]]\nkind = \"circle\"\ncentre = {}\nradius = {}\nside = \"outside\"", text_of(centre),
         one_of({0.0625, 0.5, 1.0}));
  }

  void write_balls() {
    const int count = 3 + below(4);
    std::vector<Point> places;
    std::vector<double> radii;
    const double common = one_of({0.5, 0.5, 0.25});
    for (int i = 0; i < count; ++i) {
      for (int attempt = 0; attempt < 30; ++attempt) {
        const double radius = radius_or(common);
        const Point x = place(places, radii, radius);
        if (!fits(x, radius, places, radii)) continue;
        places.push_back(x);
        radii.push_back(radius);
        write_ball(x, radius);
        break;
      }
    }
  }

  [[nodiscard]] double radius_or(double common) {
    if (kind_ == Kind::grid) return dimension_ > 1 && chance(0.05) ? 0.0 : common;
    if (kind_ == Kind::extreme) return std::ldexp(between(0.5, 1.0), -below(9));
    return between(0.1, 0.7);
  }

  /// Anywhere, or touching a ball that is there along an axis or in the direction (3, 4)/5.
  [[nodiscard]] Point place(const std::vector<Point>& places, const std::vector<double>& radii, double radius) {
    Point x;
    if (!places.empty() && chance(0.4)) {
      const auto at = static_cast<std::size_t>(below(static_cast<int>(places.size())));
      x = places[at];
      const double reach = (radii[at] + radius) * (chance(0.5) ? 1.0 : -1.0);
      if (dimension_ > 1 && chance(0.3)) {
        x[0] += 0.6 * reach;
        x[1] += 0.8 * reach;
      } else {
        x[static_cast<std::size_t>(below(dimension_))] += reach;
      }
      return x;
    }
    for (int k = 0; k < dimension_; ++k) x.push_back(coordinate());
    return x;
  }

  /// Roughly: the reader has the last word.
  [[nodiscard]] bool fits(const Point& x, double radius, const std::vector<Point>& places,
                          const std::vector<double>& radii) const {
    if (boxed_)
      for (const double c : x)
        if (c < radius || c > side - radius) return false;
    for (std::size_t i = 0; i < places.size(); ++i) {
      double square = 0;
      for (std::size_t k = 0; k < x.size(); ++k) {
        double d = x[k] - places[i][k];
        if (periodic_) d -= side * std::round(d / side);
        square += d * d;
      }
      const double reach = radius + radii[i];
      if (square < reach * reach * (1 - 1e-15)) return false;
    }
    return true;
  }

  [[nodiscard]] double speed() {
    if (kind_ == Kind::grid) return one_of({-1.0, -0.5, 0.0, 0.0, 0.5, 1.0});
    if (kind_ == Kind::extreme) return std::ldexp(between(-1.0, 1.0), below(81) - 40);
    return between(-1.0, 1.0);
  }

  void write_ball(const Point& x, double radius) {
    Point v;
    for (int k = 0; k < dimension_; ++k) v.push_back(speed());
    for (const double c : v) fastest_ = std::max(fastest_, std::abs(c));
    line("[[ball]]\nposition = {}\nvelocity = {}\nradius = {}", text_of(x), text_of(v), radius);
    const double what = dice_.uniform();
    if (what < 0.05) {
      text_.erase(text_.rfind("velocity"));
      line("radius = {}\nfixed = true", radius);
    } else if (what < 0.08) {
      line("mass = inf");
    } else if (kind_ == Kind::extreme) {
      line("mass = {:.3e}", std::exp(between(-27.6, 27.6)));
    } else if (what < 0.5) {
      line("mass = {}", kind_ == Kind::grid ? one_of({1.0, 2.0, 3.0}) : between(0.2, 5.0));
    }
  }

  [[nodiscard]] double until() const {
    const double crossing = side / (fastest_ > 0 ? fastest_ : 1.0);
    const double long_enough = 50.0 * crossing + (kind_ == Kind::extreme ? 0.0 : 10.0);
    return accelerated_ ? std::min(200.0, long_enough) : 50.0 * crossing;
  }

  static constexpr int side = 8;

  RandomStream dice_;
  std::string text_;
  int dimension_ = 2;
  Kind kind_ = Kind::grid;
  bool boxed_ = false, periodic_ = false, accelerated_ = false;
  double fastest_ = 0.0;
};

}  // namespace

std::string any_scene(std::uint64_t number) { return Writer(number).write(); }

}  // namespace carom::testing
