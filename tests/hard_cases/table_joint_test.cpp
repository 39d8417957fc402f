// No closed table leaks: a point aimed at every joint of its pieces, and beside it by 1e-16 .. 1e-8, from several places,
// stays inside, and so do those that come to the joints by themselves. CAROM_TABLE_HITS sets the number of hits of each ray
// (40; a long run: 5000, which makes 10^6 and more at each table).

#include <cmath>
#include <cstdlib>
#include <functional>

#include "carom/scene/read.hpp"
#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;
using Point = std::array<double, 2>;

struct ClosedTable {
  std::string keys;
  std::vector<Point> joints;                          // in the frame of the table
  std::function<double(const Point&)> depth;          // how far inside, at least; negative outside
};

double in_mushroom(const Point& p, double r, double half, double length) {
  const double cap = std::min(p[1], r - std::hypot(p[0], p[1]));
  return std::max(cap, std::min({half - std::abs(p[0]), p[1] + length, -p[1]}));
}

std::vector<ClosedTable> closed_tables() {
  const double h = 0.8660254037844386;
  return {{"kind = \"rectangle\"\nsize = [2, 1]", {{-1, -0.5}, {1, -0.5}, {1, 0.5}, {-1, 0.5}},
           [](const Point& p) { return std::min(1 - std::abs(p[0]), 0.5 - std::abs(p[1])); }},
          {"kind = \"polygon\"\nsides = 6\nside = 1", {{-0.5, -h}, {0.5, -h}, {1, 0}, {0.5, h}, {-0.5, h}, {-1, 0}},
           [h](const Point& p) { return std::min(h - std::abs(p[1]), h - (h * std::abs(p[0]) + 0.5 * std::abs(p[1]))); }},
          {"kind = \"stadium\"\nradius = 1\nlength = 2", {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}},
           [](const Point& p) { return 1 - std::hypot(std::max(std::abs(p[0]) - 1, 0.0), p[1]); }},
          {"kind = \"mushroom\"\ncap_radius = 1\nstem_width = 0.75\nstem_length = 1",
           {{1, 0}, {-1, 0}, {-0.375, 0}, {-0.375, -1}, {0.375, -1}, {0.375, 0}},
           [](const Point& p) { return in_mushroom(p, 1, 0.375, 1); }},
          {"kind = \"mushroom\"\ncap_radius = 1\nstem_width = 2\nstem_length = 0.5", {{1, 0}, {-1, 0}, {-1, -0.5}, {1, -0.5}},
           [](const Point& p) { return in_mushroom(p, 1, 1, 0.5); }}};
}

Point turned(const Point& p, double angle) {
  return {std::cos(angle) * p[0] - std::sin(angle) * p[1], std::sin(angle) * p[0] + std::cos(angle) * p[1]};
}

TEST(TableJoint, lets_nothing_out) {
  const char* asked = std::getenv("CAROM_TABLE_HITS");
  const std::int64_t hits = asked != nullptr ? std::atoll(asked) : 40;
  for (const ClosedTable& table : closed_tables())
    for (const double angle : {0.0, 0.7}) {
      const std::string turn = angle == 0 ? "" : "\nangle = 0.7";
      Scene scene = read_scene("[[table]]\n" + table.keys + turn + "\n[[ball]]\nposition = [0, 0]\nradius = 0\n[run]\nevents = 1\n",
                               "test.toml");
      Dice dice(5);
      for (const Point& joint : table.joints)
        for (const double offset : {0.0, 1e-16, -1e-16, 1e-12, -1e-12, 1e-8, -1e-8})
          for (int start = 0; start < 2; ++start) {
            Point from;
            do {
              const double x = dice.between(-1.0, 1.0), y = dice.between(-1.0, 1.0);
              from = {x, y};
            } while (table.depth(from) < 0.05);
            const Point a = turned(from, angle), b = turned(joint, angle);
            const double dx = b[0] - a[0], dy = b[1] - a[1], length = std::hypot(dx, dy);
            scene.balls[0].position = {a[0], a[1]};
            scene.balls[0].velocity = {(dx - offset * dy / length) / length, (dy + offset * dx / length) / length};
            const Result result = run(scene, hits);
            const std::string what = table.keys + turn + " offset " + std::to_string(offset);
            ASSERT_EQ(result.log.size(), static_cast<std::size_t>(hits)) << "it got out of " << what;
            for (const Collision& c : result.log) {
              const Point at = turned({c.ball.position[0], c.ball.position[1]}, -angle);
              ASSERT_GT(table.depth(at), -1e-9) << "it is out of " << what;
            }
          }
    }
}

}  // namespace
}  // namespace carom
