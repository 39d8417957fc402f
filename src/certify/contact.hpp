#pragma once
// When a known meeting happens: an enclosure of the root, and the proof that there is one.

#include <functional>
#include <string>

#include "carom/certify/positivity.hpp"
#include "enclosure.hpp"

namespace carom::certify {

/// The root is at base + offset.
struct Contact {
  Proof proof = Proof::unknown;
  std::string what;  ///< why not, in words
  Enclosure base;    ///< [time] a point
  Enclosure offset;  ///< [time]
  [[nodiscard]] Enclosure time() const { return base + offset; }
};

/// The fall of a gap through 0 near the point `guess`, by interval Newton steps: N = -p(0) / p'(T) inside T proves that p has
/// exactly one root in T, and that it is in N [Moore2009]. p' < 0 on T proves that the bodies close. `gap_at(base)` is the
/// gap as a polynomial of the time since the point `base`. `reach` is how far from the guess a root is looked for.
[[nodiscard]] Contact find_contact(const std::function<Polynomial<Enclosure>(const Enclosure& base)>& gap_at, const Enclosure& guess,
                                   const Enclosure& reach);

/// p(t) and p'(t).
[[nodiscard]] Enclosure value(const Polynomial<Enclosure>& p, const Enclosure& t);
[[nodiscard]] Enclosure slope(const Polynomial<Enclosure>& p, const Enclosure& t);

}  // namespace carom::certify
