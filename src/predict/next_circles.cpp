#include "carom/predict/next_circles.hpp"

#include <algorithm>

#include "carom/world/wall_images.hpp"

namespace carom {

namespace {

using Vector = Vec<double, 2>;

/// Of widths and ways: far more than rounding.
constexpr double slack = 0x1p-20;
/// Circles that the scene puts so many periods away from its cell have no lists.
constexpr std::int32_t farthest = 1 << 14;

/// A circle that may be met after another.
struct Candidate {
  Vector away;      // from centre to centre
  double reach;     // of both together
  double clear;     // least way between
  std::uint32_t row;
  Image<2> image;  // relative to the other
};

/// The middle and the two edges of a sector, from its edge along the axis to that along the diagonal.
struct Cone {
  Vector first, middle, last;
};
Cone cone_of(std::uint32_t sector) {
  const std::uint32_t octant = sector / 4, step = sector % 4;
  const auto direction = [octant](double tangent) {
    Vector u(1.0, tangent);
    if ((octant & 4) != 0) std::swap(u[0], u[1]);
    if ((octant & 1) != 0) u[0] = -u[0];
    if ((octant & 2) != 0) u[1] = -u[1];
    return u;
  };
  return {direction(step * 0.25), direction(step * 0.25 + 0.125), direction(step * 0.25 + 0.25)};
}

double cross(const Vector& a, const Vector& b) { return a[0] * b[1] - a[1] * b[0]; }

bool near_ray(const Vector& x, const Vector& u, double reach) {
  if (dot<double, 2>(x, u) <= 0) return dot<double, 2>(x, x) <= reach * reach;
  const double across = cross(u, x);
  return across * across <= reach * reach * dot<double, 2>(u, u);
}
/// x lies within reach of the cone.
bool near_cone(const Vector& x, const Cone& cone, double reach) {
  const double turn = cross(cone.first, cone.last);
  if (cross(cone.first, x) * turn >= 0 && cross(x, cone.last) * turn >= 0) return true;
  return near_ray(x, cone.first, reach) || near_ray(x, cone.last, reach);
}

/// All that may be met after circle `from` on a way of `limit`, the nearest first.
std::vector<Candidate> candidates(const Space<double, 2>& space, const std::vector<Sphere<double, 2>>& circles, double radius,
                                  std::uint32_t from, double& limit) {
  const int far = circles.size() <= 4 ? 5 : circles.size() <= 16 ? 3 : 1;  // periods around that are looked at
  const auto reach = [&](const auto& circle) { return circle.radius + radius; };
  double largest = 0;
  for (const auto& circle : circles) largest = std::max(largest, reach(circle));
  limit = std::max(0.0, (far + 0.5) * space.edge.minCoeff() - reach(circles[from]) - largest);
  std::vector<Candidate> found;
  for (std::uint32_t row = 0; row < circles.size(); ++row) {
    const Vector away = circles[row].centre - circles[from].centre;
    Image<2> near, n;
    for (int k = 0; k < 2; ++k) near[k] = -static_cast<std::int32_t>(std::lround(away[k] / space.edge[k]));
    for (n[0] = near[0] - far; n[0] <= near[0] + far; ++n[0])
      for (n[1] = near[1] - far; n[1] <= near[1] + far; ++n[1]) {
        if (row == from && n == Image<2>{}) continue;
        Candidate c{away, reach(circles[from]) + reach(circles[row]), 0, row, n};
        for (int k = 0; k < 2; ++k) c.away[k] += n[k] * space.edge[k];
        c.clear = std::max(0.0, std::sqrt(dot<double, 2>(c.away, c.away)) - c.reach);
        if (c.clear < limit) found.push_back(c);
      }
  }
  std::sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) { return a.clear < b.clear; });
  return found;
}

}  // namespace

NextCircles::NextCircles(const Space<double, 2>& space, const std::vector<Sphere<double, 2>>& circles, double radius,
                         Of of) {
  if (circles.size() > most_circles) return;
  const double edge = space.edge.minCoeff();
  for (std::uint32_t row = 0; row < circles.size(); ++row) {
    double limit;
    const std::vector<Candidate> near = candidates(space, circles, radius, row, limit);
    std::array<std::vector<const Candidate*>, sectors> chosen;
    for (std::uint32_t s = 0; s < sectors; ++s) {
      const Cone cone = cone_of(s);
      for (const Candidate& c : near) {
        if (chosen[s].size() > depth * lanes) break;
        if (near_cone(c.away, cone, c.reach * (1 + slack) + edge * slack)) chosen[s].push_back(&c);
      }
    }
    std::array<std::int32_t, 2>& lowest = lowest_.emplace_back();
    for (std::size_t k = 0; k < 2; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      lowest[k] = -1 - static_cast<std::int32_t>(std::floor((circles[row].centre[axis] - space.lower[axis]) / space.edge[axis]));
    }
    for (std::int32_t p = 0; p < 9; ++p) {
      Image<2> image;
      image[0] = lowest[0] + p % 3;
      image[1] = lowest[1] + p / 3;
      const Vector at = moved_by(space, circles[row], image).centre;
      double beside = 0;
      for (int k = 0; k < 2; ++k)
        beside += std::pow(std::max({0.0, space.lower[k] - at[k], at[k] - space.lower[k] - space.edge[k]}), 2);
      const bool out_of_reach = std::sqrt(beside) > (circles[row].radius + radius) * (1 + slack) + edge * slack;
      if (out_of_reach || std::max(std::abs(image[0]), std::abs(image[1])) > farthest) {
        lists_.push_back(no_list);
        continue;
      }
      lists_.push_back(static_cast<std::uint32_t>(fours_.size()));
      for (std::uint32_t s = 0; s < sectors; ++s)
        for (std::uint32_t group = 0; group < depth; ++group) {
          FourCircles& four = fours_.emplace_back();
          FourShifts shift;
          const std::size_t first = group * lanes, next = first + lanes;
          const double clear = next < chosen[s].size() ? chosen[s][next]->clear : limit;
          const double way = std::max(0.0, clear * (1 - slack) - edge * slack);
          four.within = way * way;
          for (std::size_t m = 0; m < lanes; ++m) {
            if (first + m >= chosen[s].size()) {  // one that stands behind is never met
              const Vector behind = at - cone_of(s).middle * (edge / slack);
              four.x[m] = behind[0];
              four.y[m] = behind[1];
              four.sigma[m] = circles[row].radius + radius;
              continue;
            }
            const Candidate& c = *chosen[s][first + m];
            Image<2> n;
            for (int k = 0; k < 2; ++k) n[k] = image[k] + c.image[k];
            const Vector centre = of == Of::balls ? circles[c.row].centre : moved_by(space, circles[c.row], n).centre;
            four.x[m] = centre[0];
            four.y[m] = centre[1];
            shift.x[m] = n[0] * space.edge[0];
            shift.y[m] = n[1] * space.edge[1];
            four.sigma[m] = circles[c.row].radius + radius;
            four.row[m] = static_cast<std::uint16_t>(c.row);
            for (int k = 0; k < 2; ++k) four.image[m][k] = static_cast<std::int16_t>(n[k]);
          }
          if (of == Of::balls) shifts_.push_back(shift);
        }
    }
  }
}

}  // namespace carom
