#pragma once
// What an impact on a round surface does to positions and velocities, as a function of the state before it, and its
// derivative [papers/certify/README.md, section 4].

#include "contact.hpp"
#include "gaps.hpp"

namespace carom::certify {

/// Of a relative motion y + u s + a s^2/2 that reaches |y| = sigma at s: n the normal there, nu = n.(u + a s), and
///   h = n nu,   g = h s.
/// The impact adds a share of h to the velocity and of -g to the position, both taken at the base. In mean-value form: the
/// values at the middle of the box of states, and the derivatives over all of the box:
///   dh = k dy + (n n^T + s k) du,   dg = (s k - n n^T) dy + s^2 k du.
class Jump {
 public:
  using Matrix = std::array<Triple<Enclosure>, 3>;

  /// `middle` is a state in the box of `r`; `offset` encloses s for all of the box.
  Jump(const Gaps<Enclosure>& gaps, std::size_t dimension, const Relative<Enclosure>& r, const Relative<Enclosure>& middle,
       const Enclosure& sigma, const Enclosure& offset);

  Triple<Enclosure> h, g;     ///< at the middle
  Matrix h_y, h_u, g_y, g_u;  ///< over the box
};

/// The middle of a state, and what is left of it.
[[nodiscard]] State<Enclosure> middle_of(const State<Enclosure>& state, std::size_t dimension);
[[nodiscard]] State<Enclosure> difference(const State<Enclosure>& a, const State<Enclosure>& b, std::size_t dimension);

}  // namespace carom::certify
