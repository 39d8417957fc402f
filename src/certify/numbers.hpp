#pragma once
// A system, and balls in flight, in intervals of type I: Enclosure, or Outward as a first try.

#include <array>
#include <vector>

#include "carom/certify/claim.hpp"
#include "carom/certify/system.hpp"
#include "enclosure.hpp"

namespace carom::certify {

/// Three components; those beyond the dimension are 0 and not read.
template <class I>
using Triple = std::array<I, 3>;

inline void convert(const Enclosure& from, Enclosure& to) { to = from; }
inline void convert(const Enclosure& from, Outward& to) { to = from.outward(); }
template <class I>
void convert(const Triple<Enclosure>& from, Triple<I>& to) {
  for (std::size_t k = 0; k < 3; ++k) convert(from[k], to[k]);
}

template <class I>
struct PieceNumbers {
  Triple<I> point, direction, velocity;
  Triple<I> left;    ///< of an edge: its direction, turned by a right angle
  I radius;
  I length, square;  ///< of the direction
};

template <class I>
struct Numbers {
  I start;
  Triple<I> acceleration, period;
  std::vector<I> radius;
  std::vector<PieceNumbers<I>> pieces;
};

[[nodiscard]] Numbers<Enclosure> numbers_of(const System& system);
[[nodiscard]] Numbers<Outward> coarse(const Numbers<Enclosure>& numbers);

template <class I>
struct State {
  Triple<I> x, v;
};

/// What a flight began with; event 0: the start.
struct Met {
  std::int64_t event = 0;
  MeetingKind kind = MeetingKind::ball_ball;
  std::uint32_t partner = 0;             ///< ball
  std::size_t piece = 0;                 ///< ball_wall
  std::array<std::int64_t, 3> period{};  ///< of the partner, seen from the ball
  int side = 1;                          ///< of an edge
  int order = 1;                         ///< of the zero that the overlap function has there: 2 after a plastic impact
};

/// A ball between two of its events. The state is given at a moment that is a point, so that no uncertainty of a time
/// enters where two flights are set beside each other.
struct Flight {
  Enclosure reference;      ///< [time] a point; the state there, on the flight or before it
  State<Enclosure> state;
  State<Outward> near;      ///< the same in doubles
  Enclosure start;          ///< [time] when it began
  Enclosure earliest;       ///< the lower end of that
  Met met;
};

template <class I>
[[nodiscard]] const State<I>& state_of(const Flight& f) {
  if constexpr (std::is_same_v<I, Enclosure>) {
    return f.state;
  } else {
    return f.near;
  }
}
template <class I>
[[nodiscard]] I time_between(const Enclosure& from, const Enclosure& to) {
  I t;
  convert(to - from, t);
  return t;
}

}  // namespace carom::certify
