#pragma once
// Bodies that touch at one instant, and what becomes of them.

#include <array>
#include <cstdint>
#include <vector>

#include "carom/core/double_double.hpp"
#include "carom/core/vec.hpp"

namespace carom {

/// Bodies and the contacts between them. A wall is a body of infinite mass that has the wall's velocity.
template <class Real, int D>
struct Cluster {
  struct Body {
    Real mass;              ///< [mass unit] > 0, or infinity
    Vec<Real, D> velocity;  ///< [length unit / L] before
  };
  struct Contact {
    std::size_t a, b;             ///< numbers of two different bodies
    std::array<Wide<Real>, D> r;  ///< from body a's centre towards body b's (or along a wall's normal); any length > 0
    Real e = Real(1);             ///< coefficient of restitution [-], 0..1
  };
  std::vector<Body> bodies;
  std::vector<Contact> contacts;
};

template <class Real, int D>
struct ClusterOutcome {
  std::vector<Vec<Real, D>> velocities;  ///< after, one a body
  std::vector<Real> impulses;            ///< [mass unit length unit / L] one a contact: the size of its impulse, >= 0
  Wide<Real> dissipated{Real(0)};        ///< [energy] >= 0
  Wide<Real> injected{Real(0)};          ///< [energy] work of the infinite masses
  std::int64_t reflections = 0;          ///< how many it took, all connected parts together
  std::vector<std::size_t> pinned;       ///< contacts that no motion can open: plastic, whatever e says
  std::vector<std::size_t> crushed;      ///< contacts that no finite impulses can end: their bodies keep their velocities
  std::vector<std::size_t> cut_short;    ///< contacts of parts that exceeded the limit of reflections: plastic
  std::vector<std::size_t> unfinished;   ///< of elastic parts that reached it: their reflections go on from here
};

/// A part whose reflections have not ended by then is taken to be plastic, and listed in `cut_short`; if it is elastic, it
/// is left as it is by then, `unfinished`. A light ball between two that are 10^8 times heavier takes about 10^4.
inline constexpr std::int64_t most_reflections = 100'000;

}  // namespace carom
