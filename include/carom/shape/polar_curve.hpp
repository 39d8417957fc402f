#pragma once
// A closed curve about a centre, r(theta) a Fourier series, with the balls inside or outside of it.

#include <cstdint>
#include <vector>

#include "carom/core/angle.hpp"
#include "carom/core/id.hpp"
#include "carom/shape/arclength.hpp"
#include "carom/shape/nearest.hpp"

namespace carom {

/// r(theta) = sum of cosines[k] cos k theta + sines[k] sin k theta >= 0, theta from `axis`, anticlockwise. Evaluated with
/// the library's sin, cos and atan2: its events are the same on machines that have the same of those.
template <class Real>
struct PolarCurve {
  WallId wall{};
  std::int32_t feature = 0;
  Vec<Real, 2> centre;    ///< [length unit] at the world's start
  Vec<Real, 2> velocity;  ///< [length unit / L]
  Vec<Real, 2> axis;      ///< unit, the direction theta = 0
  std::vector<Real> cosines, sines;  ///< [length unit] of equal length
  Real round = Real(0);              ///< 2 pi
  bool inside = true;                ///< the balls are inside
  Arclength<Real> length{};          ///< from theta = 0, anticlockwise

  /// r, r' and r'' at an angle.
  struct Radius {
    Real r = Real(0), rate = Real(0), bend = Real(0);
  };
  [[nodiscard]] Radius radius_at(const Real& c, const Real& s) const {
    Radius all;
    Real ck(1), sk(0);
    for (std::size_t k = 0; k < cosines.size(); ++k) {
      const Real n(static_cast<double>(k)), wave = cosines[k] * ck + sines[k] * sk;
      all.r += wave;
      all.rate += n * (sines[k] * ck - cosines[k] * sk);
      all.bend -= n * n * wave;
      const Real next = ck * c - sk * s;
      sk = sk * c + ck * s;
      ck = next;
    }
    return all;
  }
  [[nodiscard]] Vec<Real, 2> turned(const Real& along, const Real& across) const {
    return Vec<Real, 2>(axis[0] * along - axis[1] * across, axis[1] * along + axis[0] * across);
  }

  // Traced.
  [[nodiscard]] Vec<Real, 2> place(const Real& u) const {
    using std::cos;
    using std::sin;
    const Real c = cos(u), s = sin(u), r = radius_at(c, s).r;
    return turned(Real(r * c), Real(r * s));
  }
  [[nodiscard]] Vec<Real, 2> along(const Real& u) const {
    using std::cos;
    using std::sin;
    const Real c = cos(u), s = sin(u);
    const Radius at = radius_at(c, s);
    return turned(Real(at.rate * c - at.r * s), Real(at.rate * s + at.r * c));
  }
  [[nodiscard]] TracedFrame<Real> frame(const Real& u) const {
    using std::cos;
    using std::sin;
    const Real c = cos(u), s = sin(u);
    const Radius at = radius_at(c, s);
    const Real outward = at.bend - at.r, across = 2 * at.rate;
    return {turned(Real(at.r * c), Real(at.r * s)), turned(Real(at.rate * c - at.r * s), Real(at.rate * s + at.r * c)),
            turned(Real(outward * c - across * s), Real(outward * s + across * c))};
  }
  [[nodiscard]] Real begin() const { return Real(0); }
  [[nodiscard]] Real end() const { return round; }
  [[nodiscard]] bool closed() const { return true; }
  /// |y''| <= sum of (k + 1)^2 |c_k|, |y'''| <= sum of (k + 1)^3 |c_k| [papers/curved_walls.md, eq. 6].
  [[nodiscard]] Real bend_bound() const { return summed([](const Real& n) { return Real((n + 1) * (n + 1)); }); }
  [[nodiscard]] Real twist_bound() const { return summed([](const Real& n) { return Real((n + 1) * (n + 1) * (n + 1)); }); }
  [[nodiscard]] Real size() const { return summed([](const Real&) { return Real(1); }); }

  /// +1: balls are to the left of who walks it anticlockwise, which is its inside.
  [[nodiscard]] std::int8_t home() const { return inside ? 1 : -1; }
  /// Distance from the curve; < 0 on the side where the balls are not.
  [[nodiscard]] Real gap(const Vec<Real, 2>& x) const {
    const Vec<Real, 2> r = x - centre;
    const Real distance = length_of<Real>(Vec<Real, 2>(r - place(nearest_on<Real>(*this, r))));
    return within(r) == inside ? distance : Real(-distance);
  }
  /// Whether x, relative to the centre, is inside.
  [[nodiscard]] bool within(const Vec<Real, 2>& r) const {
    const Real distance = length_of<Real>(r);
    if (distance == 0) return true;
    const Real c = dot<Real, 2>(axis, r) / distance, s = cross2<Real>(axis, r) / distance;
    return distance < radius_at(c, s).r;
  }

 private:
  template <class F>
  [[nodiscard]] Real summed(F&& factor) const {
    using std::abs;
    Real sum(0);
    for (std::size_t k = 0; k < cosines.size(); ++k)
      sum += factor(Real(static_cast<double>(k))) * (abs(cosines[k]) + abs(sines[k]));
    return sum;
  }
};

}  // namespace carom
