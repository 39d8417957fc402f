#include "numbers.hpp"

#include <algorithm>

namespace carom::certify {

namespace {

Triple<Enclosure> enclosed(const Vector& v) { return {Enclosure::of(v[0]), Enclosure::of(v[1]), Enclosure::of(v[2])}; }

}  // namespace

Numbers<Enclosure> numbers_of(const System& system) {
  Numbers<Enclosure> n;
  n.start = Enclosure::of(system.start);
  n.acceleration = enclosed(system.acceleration);
  if (system.period) n.period = enclosed(*system.period);
  for (const SystemBall& b : system.balls) n.radius.push_back(Enclosure::of(b.radius));
  for (const Piece& p : system.pieces) {
    PieceNumbers<Enclosure> q;
    q.point = enclosed(p.point);
    q.direction = enclosed(p.direction);
    q.left = enclosed({-p.direction[1], p.direction[0], 0});
    q.velocity = enclosed(p.velocity);
    q.radius = Enclosure::of(p.radius);
    Rational square = 0;
    for (const Rational& c : p.direction) square += c * c;
    q.square = Enclosure::of(square);
    q.length = sqrt(q.square);
    n.pieces.push_back(q);
  }
  return n;
}

Numbers<Outward> coarse(const Numbers<Enclosure>& from) {
  Numbers<Outward> to;
  convert(from.start, to.start);
  convert(from.acceleration, to.acceleration);
  convert(from.period, to.period);
  for (const Enclosure& r : from.radius) to.radius.push_back(r.outward());
  for (const PieceNumbers<Enclosure>& p : from.pieces) {
    PieceNumbers<Outward> q;
    convert(p.point, q.point);
    convert(p.direction, q.direction);
    convert(p.left, q.left);
    convert(p.velocity, q.velocity);
    convert(p.radius, q.radius);
    convert(p.length, q.length);
    convert(p.square, q.square);
    to.pieces.push_back(q);
  }
  return to;
}

}  // namespace carom::certify
