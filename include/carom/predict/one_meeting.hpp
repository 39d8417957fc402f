#pragma once
// Where a ball's path meets a piece of a traced curve, and when that is certainly the only place.
//
// The centre of a ball of radius s that touches at u is at z(u) = y + s n, n the unit normal, and z' = (1 - s k) y', k the
// curvature on the ball's side. Between two meetings the way is a chord of z, parallel to z' somewhere on the piece by Rolle's
// theorem, and the mean of the velocities. So if v x y' has one sign on all of the piece for a time, and 1 - s k too, there is
// at most one meeting in that time, and only from the side that v comes from [papers/curved_walls.md, eq. 7].

#include <cmath>
#include <cstdint>

#include "carom/core/real.hpp"
#include "carom/shape/traced.hpp"

namespace carom {

template <class Real, Traced<Real> Curve, class Path>
class OneMeeting {
 public:
  OneMeeting(const Curve& curve, const Path& path, const Real& radius, const TracedPiece<Real>& piece)
      : curve_(curve),
        path_(path),
        radius_(radius),
        middle_((piece.from + piece.to) / 2),
        half_((piece.to - piece.from) / 2),
        frame_(curve.frame(middle_)),
        u_(middle_),
        t_(piece.bound) {}

  /// Whether there is certainly one at most on the piece, for `holds_for` before and after its moment.
  [[nodiscard]] bool at_most() {
    const Vec<Real, 2> v = path_.velocity(t_);
    side_ = cross2<Real>(frame_.along, v) < 0 ? 1 : -1;
    return judge(half_, v);
  }
  /// The same after `find`, on the piece together with what lies between it and the place found.
  [[nodiscard]] bool at_most_with_it() {
    using std::abs;
    const Real away = abs(u_ - middle_);
    return judge(away > half_ ? away : half_, path_.velocity(t_));
  }
  /// Newton's method for x(t) = z(u), as long as the two come nearer; whether they meet within `doubt`. The path may meet the
  /// curve before its beginning, and beside the piece.
  [[nodiscard]] bool find(const Real& doubt) {
    using std::abs;
    Real last = infinity<Real>(), t = t_, u = u_;
    TracedFrame<Real> at = frame_;
    for (int i = 0; i < 60; ++i) {
      const Vec<Real, 2> v = path_.velocity(t);
      const Real stretch = length_of<Real>(at.along), s = Real(side_) * radius_;
      const Vec<Real, 2> touching = at.place + at.left() * (s / stretch);
      const Vec<Real, 2> along = at.along * (1 - s * cross2<Real>(at.along, at.bend) / (stretch * stretch * stretch));
      const Vec<Real, 2> apart = touching - path_.at(t);
      const Real size = length_of<Real>(apart), crossing = cross2<Real>(v, along);
      if (!(size < last)) break;
      last = size;
      t_ = t;
      u_ = u;
      closing_ = abs(cross2<Real>(v, at.along)) / stretch;
      if (crossing == 0) break;
      t += cross2<Real>(apart, along) / crossing;
      u += cross2<Real>(apart, v) / crossing;
      if (!(abs(u - middle_) <= 4 * half_)) return false;
      if (8 * size <= doubt) {
        t_ = t;
        u_ = u;
        break;
      }
      at = curve_.frame(u);
    }
    return last <= doubt;
  }

  [[nodiscard]] const Real& time() const { return t_; }
  [[nodiscard]] const Real& parameter() const { return u_; }
  [[nodiscard]] const Real& closing() const { return closing_; }  ///< speed at which the ball comes to the curve there
  [[nodiscard]] const Real& holds_for() const { return holds_; }
  /// The path crosses the directions of all the piece one way, as it was last judged.
  [[nodiscard]] bool crosses() const { return crosses_; }
  /// The piece bends to one side all along.
  [[nodiscard]] bool bends() const {
    using std::abs;
    const Real most = length_of<Real>(frame_.along) + half_ * curve_.bend_bound();
    return abs(cross2<Real>(frame_.along, frame_.bend)) > half_ * most * curve_.twist_bound();
  }
  [[nodiscard]] std::int8_t side() const { return side_; }  ///< that the path comes from: +1 the left of the curve

 private:
  [[nodiscard]] bool judge(const Real& half, const Vec<Real, 2>& v) {
    using std::abs;
    const Real bent = half * curve_.bend_bound(), stretch = length_of<Real>(frame_.along);
    const Real least = stretch - bent, most = stretch + bent;
    const Real sure = abs(cross2<Real>(frame_.along, v)) - length_of<Real>(v) * bent;
    crosses_ = sure > 0 && least > 0;
    if (!crosses_) return false;
    const Real pull = path_.bend();
    holds_ = pull > 0 ? Real(sure / (pull * most)) : infinity<Real>();
    if (!(radius_ > 0)) return true;
    // k |y'|^3 = +- y' x y'', and its slope is y' x y'''.
    const Real turning = Real(side_) * cross2<Real>(frame_.along, frame_.bend) + half * most * curve_.twist_bound();
    return !(turning > 0) || radius_ * turning < least * least * least;
  }

  const Curve& curve_;
  const Path& path_;
  const Real& radius_;
  Real middle_, half_;
  TracedFrame<Real> frame_;  // in the middle
  Real u_, t_, closing_ = Real(0), holds_ = Real(0);
  std::int8_t side_ = 0;
  bool crosses_ = false;
};

}  // namespace carom
