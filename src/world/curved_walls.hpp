#pragma once
// Curved walls made from what the scene says of them, in the arithmetic of Real.

#include <algorithm>
#include <cmath>
#include <vector>

#include "carom/scene/scene.hpp"
#include "carom/shape/curved.hpp"
#include "carom/shape/place_doubt.hpp"
#include "carom/world/walls.hpp"
#include "real_number.hpp"

namespace carom::detail {

/// What all of them share; `length` turns a length of the scene into the world's unit.
template <class Real, class Shape, class Length>
void place_curve(Shape& shape, const WallSpec& spec, Length&& length) {
  using std::cos;
  using std::sin;
  const Real angle = real_number<Real>(spec.angle, 0);
  shape.centre = Vec<Real, 2>(length(spec.centre[0]), length(spec.centre[1]));
  shape.velocity = Vec<Real, 2>::Zero();
  if constexpr (requires { shape.axis; }) shape.axis = Vec<Real, 2>(Real(cos(angle)), Real(sin(angle)));
  if constexpr (requires { shape.round; }) shape.round = 2 * pi<Real>();
  if constexpr (requires { shape.inside; }) shape.inside = spec.side == WallSide::inside;
}

template <class Real, class Length>
[[nodiscard]] Arc<Real> make_arc(const WallSpec& spec, Length&& length) {
  using std::cos;
  using std::sin;
  Arc<Real> arc;
  place_curve<Real>(arc, spec, length);
  arc.radius = length(spec.radius);
  const Real begin = real_number<Real>(spec.from_angle, 0), end = real_number<Real>(spec.to_angle, 0), full = 2 * pi<Real>();
  arc.turn = end - begin;
  if (!(arc.turn > 0)) arc.turn += full;
  arc.whole = arc.turn > full * (1 - 8 * unit_roundoff<Real>());
  arc.wide = arc.turn > full / 2;
  const auto place = [&](const Real& angle) {
    return Vec<Real, 2>(arc.centre[0] + arc.radius * cos(angle), arc.centre[1] + arc.radius * sin(angle));
  };
  arc.from = place(begin);
  arc.to = arc.whole ? arc.from : place(end);
  return arc;
}

template <class Real, class Length>
[[nodiscard]] Ellipse<Real> make_ellipse(const WallSpec& spec, Length&& length) {
  Ellipse<Real> ellipse;
  place_curve<Real>(ellipse, spec, length);
  ellipse.a = length(spec.axes[0]);
  ellipse.b = length(spec.axes[1]);
  ellipse.length = Arclength<Real>(ellipse);
  return ellipse;
}

template <class Real, class Length>
[[nodiscard]] Parabola<Real> make_parabola(const WallSpec& spec, Length&& length) {
  Parabola<Real> parabola;
  place_curve<Real>(parabola, spec, length);
  parabola.focal_length = length(spec.focal_length);
  parabola.half_width = length(spec.half_width);
  parabola.length = Arclength<Real>(parabola);
  return parabola;
}

template <class Real, class Length>
[[nodiscard]] PolarCurve<Real> make_polar_curve(const WallSpec& spec, Length&& length) {
  PolarCurve<Real> curve;
  place_curve<Real>(curve, spec, length);
  const std::size_t terms = std::max(spec.cosines.size(), spec.sines.size());
  curve.cosines.assign(terms, Real(0));
  curve.sines.assign(terms, Real(0));
  for (std::size_t k = 0; k < spec.cosines.size(); ++k) curve.cosines[k] = length(spec.cosines[k]);
  for (std::size_t k = 1; k < spec.sines.size(); ++k) curve.sines[k] = length(spec.sines[k]);
  curve.length = Arclength<Real>(curve);
  return curve;
}

/// Pieces that end at one place are joined there: an arc takes the other's end for its own, so that both see the joint on
/// the same side of every path; and where one goes on in the other's direction, points meet no vertex.
template <class Real>
class Joints {
 public:
  explicit Joints(Walls<Real, 2>& walls) : walls_(walls) {
    for (Segment<Real>& s : walls.segments) {
      ends_.push_back({&s.from, s.along, s.velocity, &s.smooth_from, false, sure(s)});
      ends_.push_back({&s.to, Vec<Real, 2>(-s.along), s.velocity, &s.smooth_to, false, sure(s)});
    }
    for (Arc<Real>& a : walls.arcs) {
      if (a.whole) continue;
      const Vec<Real, 2> from = (a.from - a.centre) / a.radius, to = (a.to - a.centre) / a.radius;
      ends_.push_back({&a.from, Vec<Real, 2>(-from[1], from[0]), a.velocity, &a.smooth_from, true, sure(a)});
      ends_.push_back({&a.to, Vec<Real, 2>(to[1], -to[0]), a.velocity, &a.smooth_to, true, sure(a)});
    }
  }

  void join() {
    for (std::size_t i = 0; i < ends_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        if (!ends_[i].curved && !ends_[j].curved) continue;
        if (meets(ends_[i], ends_[j])) join(ends_[j], ends_[i]);
      }
  }

 private:
  struct End {
    Vec<Real, 2>* place;
    Vec<Real, 2> into;      ///< unit, from the end into the piece
    Vec<Real, 2> velocity;
    bool* smooth;
    bool curved;
    Real doubt;             ///< [rad] of the direction, by rounding
  };

  /// Rounding of a direction: that of coordinates over the length of the piece, and of an angle.
  [[nodiscard]] static Real sure(const Segment<Real>& s) {
    return place_doubt<Real>(s.from, s.from, s.to) / length_of<Real>(Vec<Real, 2>(s.to - s.from));
  }
  [[nodiscard]] static Real sure(const Arc<Real>& a) {
    return place_doubt<Real>(a.centre, a.from, a.to) / a.radius + 32 * unit_roundoff<Real>();
  }
  [[nodiscard]] static bool meets(const End& a, const End& b) {
    const Vec<Real, 2> between = *a.place - *b.place;
    return a.velocity == b.velocity && length_of<Real>(between) <= 8 * place_doubt<Real>(*a.place, *a.place, *b.place);
  }
  void join(End& first, End& second) {
    // What is curved moves: a segment's direction is that of its ends.
    End &moved = second.curved ? second : first, &kept = second.curved ? first : second;
    for (Sphere<Real, 2>& vertex : walls_.spheres)
      if (vertex.radius == 0 && vertex.centre == *moved.place) vertex.centre = *kept.place;
    *moved.place = *kept.place;
    using std::abs;
    const bool goes_on = dot<Real, 2>(first.into, second.into) < 0 &&
                         abs(cross2<Real>(first.into, second.into)) <= 2 * (first.doubt + second.doubt);
    if (!goes_on) return;
    *first.smooth = *second.smooth = true;
    for (Sphere<Real, 2>& vertex : walls_.spheres)
      if (vertex.radius == 0 && vertex.centre == *kept.place) vertex.smooth = true;
  }

  Walls<Real, 2>& walls_;
  std::vector<End> ends_;
};

}  // namespace carom::detail
