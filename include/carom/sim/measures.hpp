#pragma once
// What a collision adds to the counts of exactness and to the energy books.

#include <array>
#include <cmath>

#include "carom/law/impact.hpp"
#include "carom/sim/books.hpp"
#include "carom/sim/totals.hpp"
#include "carom/world/world.hpp"

namespace carom {

/// A gap that was left at a contact; `radii` is the sum of the radii in contact. Returns the gap.
template <class Real>
inline Real note_gap(Exactness<Real>& exactness, const Real& gap, const Real& radii) {
  using std::abs;
  const Real size = abs(gap);
  if (size > exactness.max_gap_error) exactness.max_gap_error = size;
  if (radii > 0 && size > exactness.max_gap_error_relative * radii) exactness.max_gap_error_relative = size / radii;
  return gap;
}

/// Gap between two balls, |r| - sigma, without cancellation.
template <class Real, std::size_t D>
[[nodiscard]] inline Real gap_of_pair(const std::array<Wide<Real>, D>& r, const Real& sigma) {
  using std::sqrt;
  Wide<Real> rr(Real(0));
  for (const Wide<Real>& x : r) rr = rr + x * x;
  const Wide<Real> excess = rr - wide_product<Real>(sigma, sigma);
  const Real sum = sqrt(narrow(rr)) + sigma;
  return sum > 0 ? Real(narrow(excess) / sum) : Real(0);
}

/// The lowest potential (per mass) at which a ball of finite mass was seen.
template <class Real, int D>
inline void note_potential(EnergyBooks<Real>& books, const World<Real, D>& world, std::uint32_t i) {
  if (detail::infinite(world.details[i].mass)) return;
  const auto x = unwrapped(world, i, world.balls[i].position);
  Wide<Real> p(Real(0));
  for (int k = 0; k < D; ++k) p = p - x[k] * Wide<Real>(world.acceleration[k]);
  if (narrow(p) < books.lowest_potential) books.lowest_potential = narrow(p);
}

template <class Real>
inline void inject(EnergyBooks<Real>& books, const Wide<Real>& work) {
  if (narrow(work) == 0) return;
  books.injected = books.injected + work;
  const Real injected = narrow(books.injected);
  if (injected > books.largest_injected) books.largest_injected = injected;
}

template <class Real, int D>
inline void book(EnergyBooks<Real>& books, const Outcome<Real, D>& outcome) {
  books.dissipated = books.dissipated + outcome.dissipated;
  inject(books, outcome.injected);
}

}  // namespace carom
