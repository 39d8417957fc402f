#pragma once
// Is a polynomial positive over a whole interval? A proof, or none.

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "carom/certify/outward.hpp"

namespace carom::certify {

/// What was found out: it holds; it cannot be told; it does not.
enum class Proof : std::uint8_t { yes, unknown, no };

/// c0 + c1 t + c2 t^2 + ...; of enclosed coefficients: all polynomials with coefficients in them.
template <class I>
using Polynomial = std::vector<I>;

/// p(t + shift).
template <class I>
[[nodiscard]] Polynomial<I> shifted(Polynomial<I> p, const I& shift) {
  for (std::size_t k = 0; k + 1 < p.size(); ++k)
    for (std::size_t i = p.size() - 1; i-- > k;) p[i] = p[i] + shift * p[i + 1];
  return p;
}

/// p / (t - root), by Horner's scheme. Requires p(root) = 0 for the polynomial and root that are meant: the remainder is
/// dropped.
template <class I>
[[nodiscard]] Polynomial<I> without_root(const Polynomial<I>& p, const I& root) {
  if (p.size() < 2) return p;
  Polynomial<I> q(p.size() - 1);
  q.back() = p.back();
  for (std::size_t i = q.size() - 1; i-- > 0;) q[i] = p[i + 1] + root * q[i + 1];
  return q;
}

template <class I>
[[nodiscard]] Polynomial<I> negated(Polynomial<I> p) {
  for (I& c : p) c = -c;
  return p;
}

/// Coefficients b_j = sum_k C(j, k) / C(n, k) q_k of q(s) = p(from + (to - from) s) in the Bernstein basis on [0, 1]. The
/// first and the last are the values at the ends, and q lies between the smallest and the largest of them [Farouki2012].
template <class I>
[[nodiscard]] std::vector<I> bernstein(const Polynomial<I>& p, const I& from, const I& to) {
  static constexpr int binomial[5][5] = {{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}, {1, 4, 6, 4, 1}};
  Polynomial<I> q = shifted(p, from);
  const I length = to - from;
  I power = length;
  for (std::size_t k = 1; k < q.size(); ++k, power = power * length) q[k] = q[k] * power;
  const std::size_t n = q.size() - 1;
  std::vector<I> b(q.size());
  for (std::size_t j = 0; j <= n; ++j) {
    b[j] = q[0];
    for (std::size_t k = 1; k <= j; ++k)
      b[j] = b[j] + (binomial[j][k] == binomial[n][k] ? q[k] : ratio<I>(binomial[j][k], binomial[n][k]) * q[k]);
  }
  return b;
}

/// Cuts at the middle [de Casteljau]: the left half, and the right half stays in `b`.
template <class I>
[[nodiscard]] std::vector<I> cut(std::vector<I>& b) {
  std::vector<I> left;
  left.reserve(b.size());
  for (std::size_t level = b.size(); level > 0; --level) {
    left.push_back(b.front());
    for (std::size_t i = 0; i + 1 < level; ++i) b[i] = half(b[i] + b[i + 1]);
  }
  // The last entries of each level, in place, are the right half.
  return left;
}

/// The sign of q on [0, 1] as its coefficients show it.
template <class I>
[[nodiscard]] Proof shows_positive(const std::vector<I>& b) {
  bool all = true;
  for (const I& c : b) all = all && is_positive(c);
  if (all) return Proof::yes;
  return is_negative(b.front()) || is_negative(b.back()) ? Proof::no : Proof::unknown;
}

/// q > 0 on all of [0, 1]? By halving, `depth` times at most. `no` if an end of a part is surely negative.
template <class I>
[[nodiscard]] Proof positive(std::vector<I> b, int depth) {
  const Proof whole = shows_positive(b);
  if (whole != Proof::unknown) return whole;
  // An end that cannot be told from 0 stays one.
  if (depth == 0 || !is_positive(b.front()) || !is_positive(b.back())) return Proof::unknown;
  const Proof first = positive(cut(b), depth - 1);
  return first == Proof::yes ? positive(std::move(b), depth - 1) : first;
}

/// At every moment at least one of some polynomials positive? By halving, `depth` times at most. `no` if at an end of a part
/// all are surely negative.
template <class I>
[[nodiscard]] Proof one_positive(std::vector<std::vector<I>> all, int depth) {
  bool none_first = true, none_last = true, doubt_first = true, doubt_last = true;
  for (const std::vector<I>& b : all) {
    if (shows_positive(b) == Proof::yes) return Proof::yes;
    none_first = none_first && is_negative(b.front());
    none_last = none_last && is_negative(b.back());
    doubt_first = doubt_first && !is_positive(b.front());
    doubt_last = doubt_last && !is_positive(b.back());
  }
  if (none_first || none_last) return Proof::no;
  if (depth == 0 || doubt_first || doubt_last) return Proof::unknown;
  std::vector<std::vector<I>> left;
  for (std::vector<I>& b : all) left.push_back(cut(b));
  const Proof first = one_positive(std::move(left), depth - 1);
  return first == Proof::yes ? one_positive(std::move(all), depth - 1) : first;
}

}  // namespace carom::certify
