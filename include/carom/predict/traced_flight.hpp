#pragma once
// The first meeting of a ball with a curve that is traced by a parameter, by bounds that hold.
//
// A ball of radius s meets a piece of the curve no earlier than its centre comes within s + bulge of the piece's chord: a
// convex region. From outside of it the centre cannot be in it before it has come down to the plane that touches the region
// nearest to it [papers/curved_walls.md, eq. 5]. So every piece has a time before which it is not met, each look at the piece
// moves that on, and the piece with the earliest is looked at first: advanced, or halved. The first whose bulge is below
// rounding and that is reached is the answer, and no other piece is met before it. The ends of the curve are those of its
// first and last piece: the curve's own vertices. [Mirtich1996 calls the advance conservative.]

#include "carom/core/real.hpp"
#include "carom/shape/traced.hpp"
#include "carom/solve/gap.hpp"

namespace carom {

/// x + v t + a t^2 / 2, relative to the centre of a curve.
template <class Real>
struct ParabolicPath {
  Vec<Real, 2> x, v, a;

  [[nodiscard]] Vec<Real, 2> at(const Real& t) const { return x + (v + a * (t / 2)) * t; }
  [[nodiscard]] Vec<Real, 2> velocity(const Real& t) const { return v + a * t; }
  /// First time >= t at which n.x falls to `level`.
  [[nodiscard]] Real down_to(const Real& t, const Vec<Real, 2>& n, const Real& level) const {
    const Vec<Real, 2> now = at(t);
    const Real fall = first_fall(Real(dot<Real, 2>(n, now) - level), dot<Real, 2>(n, velocity(t)),
                                 Real(dot<Real, 2>(n, a) / 2));
    return fall == never<Real>() ? fall : Real(t + fall);
  }
};

/// When, and where on the curve; time `never`: not at all.
template <class Real>
struct TracedMeeting {
  Real time;
  Real parameter;
};

/// A meeting known to within rounding brought to the last bit: by Newton's method on the distance, as long as that shrinks.
template <class Real, Traced<Real> Curve, class Path>
[[nodiscard]] inline TracedMeeting<Real> sharpened(const Curve& curve, const Path& path, const Real& radius,
                                                   TracedMeeting<Real> found) {
  using std::abs;
  Real last = infinity<Real>();
  TracedMeeting<Real> next = found;
  for (int i = 0; i < 4; ++i) {
    const Vec<Real, 2> x = path.at(next.time);
    next.parameter = squared_up<Real>(curve, x, next.parameter);
    Vec<Real, 2> n = x - curve.place(next.parameter);
    const Real distance = length_of<Real>(n);
    Real gap = distance - radius;
    if (!(radius > 0)) {  // a point: over the tangent
      const Vec<Real, 2> along = curve.along(next.parameter);
      const Real stretch = length_of<Real>(along);
      if (!(stretch > 0)) return found;
      const Vec<Real, 2> left(-along[1] / stretch, along[0] / stretch);
      gap = dot<Real, 2>(left, n);
      n = left;
    } else {
      n /= distance;
    }
    if (!(abs(gap) < last)) return found;
    found = next;
    last = abs(gap);
    const Real rate = dot<Real, 2>(n, path.velocity(next.time));
    if (last == 0 || rate == 0) return found;
    next.time -= gap / rate;
    if (!(next.time > 0)) return found;
  }
  return found;
}

/// The first meeting at or after time 0. `starts(u)` is asked where the ball is at the curve from the outset, within
/// rounding: whether that is a meeting now.
template <class Real, Traced<Real> Curve, class Path, class Starts>
[[nodiscard]] TracedMeeting<Real> first_meeting(const Curve& curve, const Path& path, const Real& radius, Starts&& starts) {
  const Real doubt = traced_doubt<Real>(curve, path.at(Real(0))), bend = curve.bend_bound();
  TracedPieces<Real> pieces(curve, Real(0));
  while (!pieces.empty()) {
    TracedPiece<Real> p = pieces.pop();
    const Real bulge = p.bulge(bend), reach = radius + bulge;
    const Vec<Real, 2> x = path.at(p.bound), foot = nearest_on_chord(x, p.first, p.last), r = x - foot;
    const Real distance = length_of<Real>(r);
    if (distance > reach + doubt) {
      const Vec<Real, 2> n = r / distance;
      const Real next = path.down_to(p.bound, n, Real(dot<Real, 2>(n, foot) + reach));
      if (next == never<Real>()) continue;
      if (next > p.bound) {
        p.bound = next;
        pieces.push(p);
        continue;
      }
    }
    const Real middle = (p.from + p.to) / 2;
    if (bulge > doubt) {
      pieces.push_halves(curve, p);
    } else if (p.bound > 0) {
      return sharpened<Real>(curve, path, radius, {p.bound, middle});
    } else if (starts(middle)) {
      return {Real(0), middle};
    }
  }
  return {never<Real>(), Real(0)};
}

}  // namespace carom
