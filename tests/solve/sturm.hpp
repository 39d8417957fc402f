#pragma once
// Real roots by Sturm's theorem in 300-digit arithmetic: an oracle that shares nothing with crossings.hpp.

#include <optional>
#include <vector>

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace carom::oracle {

using Digits300 =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<300>, boost::multiprecision::et_off>;
using Coefficients = std::vector<Digits300>;  // by rising powers, the last one not 0

inline Digits300 evaluate(const Coefficients& p, const Digits300& t) {
  Digits300 value = 0;
  for (auto c = p.rbegin(); c != p.rend(); ++c) value = value * t + *c;
  return value;
}

inline Coefficients slope(const Coefficients& p) {
  Coefficients q;
  for (std::size_t i = 1; i < p.size(); ++i) q.push_back(p[i] * int(i));
  return q;
}

/// p, p', and minus the remainders, as long as they are not 0. For polynomials without multiple roots.
inline std::vector<Coefficients> sturm_chain(const Coefficients& p) {
  std::vector<Coefficients> chain{p, slope(p)};
  while (chain.back().size() > 1) {
    Coefficients rest = chain[chain.size() - 2];
    const Coefficients& divisor = chain.back();
    while (rest.size() >= divisor.size()) {
      const Digits300 q = rest.back() / divisor.back();
      const std::size_t shift = rest.size() - divisor.size();
      for (std::size_t i = 0; i < divisor.size(); ++i) rest[shift + i] -= q * divisor[i];
      rest.pop_back();
    }
    for (auto& c : rest) c = -c;
    while (!rest.empty() && rest.back() == 0) rest.pop_back();
    if (rest.empty()) break;
    chain.push_back(rest);
  }
  return chain;
}

inline int sign_changes(const std::vector<Coefficients>& chain, const Digits300& t) {
  int changes = 0;
  int last = 0;
  for (const auto& p : chain) {
    const Digits300 value = evaluate(p, t);
    const int sign = value > 0 ? 1 : value < 0 ? -1 : 0;
    if (sign != 0 && last != 0 && sign != last) ++changes;
    if (sign != 0) last = sign;
  }
  return changes;
}

/// All positive roots, ascending, to about 60 digits. `limit` exceeds them all.
inline std::vector<Digits300> positive_roots(const Coefficients& p, const Digits300& limit) {
  std::vector<Digits300> roots;
  if (p.size() < 2) return roots;
  const auto chain = sturm_chain(p);
  const int at_zero = sign_changes(chain, 0);
  const int count = at_zero - sign_changes(chain, limit);
  Digits300 from = Digits300(1) / limit;
  for (int k = 1; k <= count; ++k) {
    Digits300 lo = from;
    Digits300 hi = limit;
    while (at_zero - sign_changes(chain, hi) > k || hi > 2 * lo) {  // in the logarithm: roots may lie 1e200 apart
      const Digits300 middle = hi > 2 * lo ? Digits300(sqrt(lo * hi)) : Digits300((lo + hi) / 2);
      (at_zero - sign_changes(chain, middle) >= k ? hi : lo) = middle;
    }
    const bool falls = evaluate(p, hi) < 0;
    for (int i = 0; i < 200; ++i) {
      const Digits300 middle = (lo + hi) / 2;
      ((evaluate(p, middle) < 0) == falls ? hi : lo) = middle;
    }
    roots.push_back(hi);
    from = hi;
  }
  return roots;
}

/// The overlap rule, for polynomials whose roots and turning points are simple and whose c[0] and c[1] are not 0.
inline std::optional<Digits300> first_fall(const Coefficients& p, const Digits300& limit) {
  if (p[0] < 0 && p[1] < 0) return Digits300(0);
  Digits300 after = 0;
  if (p[0] < 0) {
    const auto turns = positive_roots(slope(p), limit);
    if (turns.empty()) return {};
    if (evaluate(p, turns[0]) <= 0) return turns[0];
    after = turns[0];
  }
  for (const auto& t : positive_roots(p, limit))
    if (t > after) return t;  // f > 0 at `after`: the next simple root is a fall
  return {};
}

}  // namespace carom::oracle
