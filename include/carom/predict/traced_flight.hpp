#pragma once
// The first meeting of a ball with a curve that is traced by a parameter, by bounds that hold.
//
// A ball of radius s meets a piece of the curve no earlier than its centre comes within s + bulge of the piece's chord: a
// convex region. From outside of it the centre cannot be in it before it has come down to the plane that touches the region
// nearest to it [papers/curved_walls.md, eq. 5]. So every piece has a time before which it is not met, each look at the piece
// moves that on, and the piece with the earliest is looked at first. Where the path crosses the directions of a whole piece one
// way, the piece is met at most once [eq. 7], and Newton's method finds that meeting; it ends the search when no other piece
// can be met before it. What cannot be told so is halved, until its bulge is below rounding: then reached is met. The ends of
// the curve are those of its first and last piece: the curve's own vertices. [Mirtich1996 calls the advance conservative.]

#include <cmath>
#include <optional>

#include "carom/core/real.hpp"
#include "carom/predict/one_meeting.hpp"
#include "carom/predict/traced_path.hpp"
#include "carom/shape/nearest.hpp"

namespace carom {

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
    next.parameter = detail::squared_up<Real>(curve, x, next.parameter);
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

/// The search for the first meeting at or after time 0. `starts(u)` is asked where the ball is at the curve from the outset,
/// within rounding: whether that is a meeting now. `home`: the side of the curve that the ball is on, +1 the left; 0: not known.
/// Balls stay on the home side of a closed curve.
template <class Real, Traced<Real> Curve, class Path, class Starts>
class FirstMeeting {
 public:
  FirstMeeting(const Curve& curve, const Path& path, const Real& radius, std::int8_t home, const Starts& starts)
      : curve_(curve),
        path_(path),
        radius_(radius),
        home_(home),
        starts_(starts),
        bend_(curve.bend_bound()),
        doubt_(traced_doubt<Real>(curve, path.at(Real(0)))),
        period_(path.period()),
        finest_(64 * unit_roundoff<Real>() * (curve.end() - curve.begin())),
        pieces_(curve, Real(0)) {}

  [[nodiscard]] TracedMeeting<Real> find() {
    while (!pieces_.empty()) {
      TracedPiece<Real> p = pieces_.pop();
      if (!(p.bound < first_.time) || !(p.bound <= period_)) break;
      if (!advance(p) && !settle(p)) divide(p);
    }
    return first_;
  }

 private:
  /// Moves on the time before which the piece is not met, while its region is not reached. True: nothing is left to be done now.
  [[nodiscard]] bool advance(TracedPiece<Real>& p) {
    const Real reach = radius_ + p.bulge(bend_);
    while (true) {
      const Vec<Real, 2> x = path_.at(p.bound);
      const std::optional<Plane> plane = plane_before(p, x, reach);
      if (!plane) return false;
      const Real next = path_.down_by(p.bound, plane->n, plane->gap);
      if (!(next < first_.time) || !(next <= period_)) return true;
      if (!(next > p.bound)) return false;
      p.bound = next;
      if (!pieces_.empty() && pieces_.least_bound() < next) {
        pieces_.push(p);
        return true;
      }
    }
  }

  /// A line that x is over by `gap`, and the region of the piece is not; n a unit vector.
  struct Plane {
    Vec<Real, 2> n;
    Real gap;
  };
  /// The one that touches the region nearest to x. It is put where it touches the region whatever its direction, which rounding may
  /// have turned: that of a chord is known better than that of a short way to it.
  [[nodiscard]] std::optional<Plane> plane_before(const TracedPiece<Real>& p, const Vec<Real, 2>& x, const Real& reach) const {
    const Vec<Real, 2> chord = p.last - p.first, from_first = x - p.first, from_last = x - p.last;
    const auto plane = [&](const Vec<Real, 2>& n) {
      const Real over_first = dot<Real, 2>(n, from_first), over_last = dot<Real, 2>(n, from_last);
      return Plane{n, Real((over_first < over_last ? over_first : over_last) - reach)};
    };
    const Real before = dot<Real, 2>(chord, from_first), beyond = dot<Real, 2>(chord, from_last);
    if (!(before > 0) || !(beyond < 0)) {
      const Vec<Real, 2> r = before > 0 ? from_last : from_first;
      const Real distance = length_of<Real>(r);
      if (!(distance > reach + doubt_)) return std::nullopt;
      const Plane at_end = plane(Vec<Real, 2>(r / distance));
      if (at_end.gap > doubt_) return at_end;
    }
    const Real length = length_of<Real>(chord);
    if (!(length > 0)) return std::nullopt;
    Vec<Real, 2> n(-chord[1] / length, chord[0] / length);
    if (dot<Real, 2>(n, from_first) < 0) n = -n;
    const Plane along = plane(n);
    if (along.gap > doubt_) return along;
    return std::nullopt;
  }

  /// Whether all is known of the piece: its one meeting, or that it has none for so long.
  [[nodiscard]] bool settle(TracedPiece<Real>& p) {
    crosses_ = true;
    if (const Real until = away_until(p); until > p.bound) return later(p, until);
    if (radius_ > 0 && !curve_.closed() && (!(p.from > curve_.begin()) || !(p.to < curve_.end()))) return false;  // its ends
    OneMeeting<Real, Curve, Path> one(curve_, path_, radius_, p);
    bends_ = one.bends();
    const auto open = [&] {
      crosses_ = one.crosses();
      return false;
    };
    if (!one.at_most()) return open();
    if (curve_.closed() && one.side() != home_) return later(p, Real(p.bound + one.holds_for()));
    if (!one.find(doubt_) || !one.at_most_with_it()) return open();
    const Real t = one.time(), until = t + one.holds_for(), gap = t * one.closing();
    if (!(t - one.holds_for() <= p.bound)) return false;
    if (gap <= doubt_ && gap >= -outset * doubt_) {  // at the curve from the outset
      if (home_ != 0 && one.side() != home_) return later(p, until);
      if (p.bound == 0 && starts_(one.parameter())) {
        first_ = {Real(0), one.parameter()};
        return true;
      }
    }
    if (!(t > 0) || !is_on(one.parameter())) return later(p, until);
    if (t < first_.time) first_ = {t, one.parameter()};
    return true;
  }
  /// As long as the ball moves away from every place y on the piece, (x - y).v > 0, it does not meet it. For a time in which the
  /// way to the first of them at most doubles that product falls by at most 2 |x - y| A + |y' - y| A a unit of time.
  [[nodiscard]] Real away_until(const TracedPiece<Real>& p) const {
    using std::sqrt;
    if (!(radius_ > 0)) return p.bound;
    const Vec<Real, 2> r = path_.at(p.bound) - p.first, v = path_.velocity(p.bound);
    const Real extent = length_of<Real>(Vec<Real, 2>(p.last - p.first)) + p.bulge(bend_), speed = length_of<Real>(v);
    const Real sure = dot<Real, 2>(r, v) - (extent + doubt_) * speed, pull = path_.bend();
    if (!(sure > 0)) return p.bound;
    if (!(pull > 0)) return never<Real>();
    const Real way = length_of<Real>(r), turns = sure / (pull * (2 * way + extent)), doubles = way / (speed + sqrt(Real(pull * way)));
    return p.bound + (turns < doubles ? turns : doubles);
  }
  /// A point past an end by no more than rounding is on the curve still: it does not slip through a joint.
  [[nodiscard]] bool is_on(const Real& u) const {
    if (curve_.closed()) return true;
    const Real margin = doubt_ / length_of<Real>(curve_.along(u));
    return u >= curve_.begin() - margin && u <= curve_.end() + margin;
  }
  [[nodiscard]] bool later(TracedPiece<Real>& p, const Real& until) {
    if (!(until > p.bound)) return false;
    p.bound = until;
    if (until < period_) pieces_.push(p);
    return true;
  }

  void divide(TracedPiece<Real>& p) {
    if (p.bulge(bend_) > doubt_) return pieces_.push_halves(curve_, p);
    // Almost along the curve a path may leave it and meet it again within rounding of it: only directions tell where. One that
    // stays so near for long is at the curve.
    const bool passes = !crosses_ && bends_ && fine_ < most_fine;
    if (!crosses_ && p.to - p.from > finest_ && ++fine_ < most_fine) return pieces_.push_halves(curve_, p);
    const Real middle = (p.from + p.to) / 2;
    if (p.bound > 0) {
      if (passes) return;
      const TracedMeeting<Real> met = sharpened<Real>(curve_, path_, radius_, {p.bound, middle});
      if (met.time < first_.time) first_ = met;
    } else if (starts_(middle)) {
      first_ = {Real(0), middle};
    } else if (period_ < never<Real>()) {  // a circle is far from its beginning half-way
      p.bound = period_ / 2;
      pieces_.push(p);
    }
  }

  // An overlap of so many doubts is still that of a ball at the curve, which rounding has put there.
  static constexpr int outset = 1024;
  // Pieces below rounding are divided so often, where one tangent alone takes some hundred.
  static constexpr int most_fine = 4096;

  const Curve& curve_;
  const Path& path_;
  const Real& radius_;
  std::int8_t home_;
  const Starts& starts_;
  Real bend_, doubt_, period_;
  Real finest_;  // rounding of the parameter
  int fine_ = 0;
  // Of the piece in hand: the path crosses its directions one way, and it bends one way.
  bool crosses_ = false, bends_ = false;
  TracedPieces<Real> pieces_;
  TracedMeeting<Real> first_{never<Real>(), Real(0)};
};

}  // namespace carom
