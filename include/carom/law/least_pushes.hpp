#pragma once
// Pushes without pulls: the x >= 0 of a small convex problem, by an active set that stands redundant columns.

#include <algorithm>
#include <optional>
#include <vector>

#include "carom/core/check.hpp"
#include "carom/core/double_double.hpp"

namespace carom {

/// Errors relative to what a sum is made of.
template <class W>
struct PushErrors {
  W arithmetic;  ///< rounding errors of W
  W given;       ///< of the columns: one that lies that close to the span of others is taken to lie in it
};

/// Minimise |A x|^2 / 2 - c.x over x >= 0 [papers/simultaneous.md, eq. 6]. Columns of A have length 1 and equal heights.
template <class W>
struct PushProblem {
  std::vector<std::vector<W>> columns;
  std::vector<W> c;
  std::vector<W> slack;  ///< what of c[j] cannot be told from 0
  std::vector<W> size;   ///< sum of the sizes of the terms that c[j] is made of

  [[nodiscard]] std::size_t count() const { return columns.size(); }
};

namespace detail {

template <class W>
[[nodiscard]] W inner(const std::vector<W>& u, const std::vector<W>& v) {
  W s(0);
  for (std::size_t i = 0; i < u.size(); ++i) s = s + u[i] * v[i];
  return s;
}

template <class W>
void subtract(std::vector<W>& u, const W& factor, const std::vector<W>& v) {
  for (std::size_t i = 0; i < u.size(); ++i) u[i] = u[i] - factor * v[i];
}

/// Chosen columns as Q R, grown and cut at the end. Gram-Schmidt carried out twice, which is enough [Giraud2005].
template <class W>
class OrthogonalBasis {
 public:
  [[nodiscard]] std::size_t size() const { return q_.size(); }
  void cut(std::size_t n) {
    q_.resize(n);
    r_.resize(n);
  }

  /// True: a is the new last column. False: at most `smallest` of a, of length 1, lies outside the span of the others.
  [[nodiscard]] bool grow(std::vector<W> a, const W& smallest) {
    std::vector<W> along = take_out(a);
    const W rest = inner(a, a);
    if (!(rest > smallest * smallest)) {
      last_along_ = std::move(along);
      return false;
    }
    using std::sqrt;
    const W length = sqrt(rest);
    for (W& x : a) x = x / length;
    along.push_back(length);
    q_.push_back(std::move(a));
    r_.push_back(std::move(along));
    return true;
  }

  /// Takes from a what lies in the span; the length of the rest.
  [[nodiscard]] W part_across(std::vector<W>& a) const {
    using std::sqrt;
    static_cast<void>(take_out(a));
    return sqrt(inner(a, a));
  }

  /// s with R^T R s = b.
  [[nodiscard]] std::vector<W> solve_normal(std::vector<W> b) const {
    for (std::size_t i = 0; i < size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) b[i] = b[i] - r_[i][k] * b[k];
      b[i] = b[i] / r_[i][i];
    }
    return back(std::move(b));
  }

  /// The column that `grow` refused last, in terms of the others.
  [[nodiscard]] std::vector<W> in_terms_of_the_others() const { return back(last_along_); }

 private:
  [[nodiscard]] std::vector<W> take_out(std::vector<W>& a) const {
    std::vector<W> along(size(), W(0));
    for (int pass = 0; pass < 2; ++pass)
      for (std::size_t i = 0; i < size(); ++i) {
        const W h = inner(q_[i], a);
        along[i] = along[i] + h;
        subtract(a, h, q_[i]);
      }
    return along;
  }

  [[nodiscard]] std::vector<W> back(std::vector<W> b) const {
    for (std::size_t i = size(); i-- > 0;) {
      b[i] = b[i] / r_[i][i];
      for (std::size_t k = 0; k < i; ++k) b[k] = b[k] - r_[i][k] * b[i];
    }
    return b;
  }

  std::vector<std::vector<W>> q_, r_;  // columns; column i of R has i + 1 entries
  std::vector<W> last_along_;
};

/// The active set of Lawson and Hanson [LawsonHanson1974, ch. 23] for (6), with the exchange of a dependent column.
template <class W>
class ActiveSet {
 public:
  ActiveSet(const PushProblem<W>& problem, PushErrors<W> errors)
      : problem_(problem), errors_(std::move(errors)), x_(problem.count(), W(0)) {
    for (const W& size : problem.size)
      if (errors_.arithmetic * size > noise_) noise_ = errors_.arithmetic * size;
  }

  /// False: |A x|^2 / 2 - c.x has no minimum.
  [[nodiscard]] bool solve() {
    std::vector<bool> refused(problem_.count(), false);
    for (std::size_t round = 0; round < 10 * problem_.count() + 20; ++round) {
      const std::vector<W> p = product();
      const std::optional<std::size_t> j = steepest(p, refused);
      if (!j) break;
      if (!include(*j, refused)) return false;
      if (!refused[*j]) descend(*j, refused);
    }
    refine();
    return true;
  }

  [[nodiscard]] const std::vector<W>& x() const { return x_; }
  [[nodiscard]] const std::vector<std::size_t>& chosen() const { return chosen_; }

 private:
  [[nodiscard]] std::vector<W> product() const {  // A x
    std::vector<W> p(problem_.columns.front().size(), W(0));
    for (const std::size_t j : chosen_) subtract(p, W(-x_[j]), problem_.columns[j]);
    return p;
  }

  /// What x_j gains, w_j = c_j - a_j.A x: the column outside the set that gains most, beyond doubt.
  [[nodiscard]] std::optional<std::size_t> steepest(const std::vector<W>& p, const std::vector<bool>& refused) const {
    using std::abs;
    std::optional<std::size_t> best;
    W most(0);
    for (std::size_t j = 0; j < problem_.count(); ++j) {
      if (refused[j] || std::find(chosen_.begin(), chosen_.end(), j) != chosen_.end()) continue;
      const std::vector<W>& a = problem_.columns[j];
      W size(0);
      for (std::size_t i = 0; i < a.size(); ++i) size = size + abs(W(a[i] * p[i]));
      const W gain = problem_.c[j] - inner(a, p);
      if (gain > problem_.slack[j] + errors_.arithmetic * size + noise_ && gain > most) {
        most = gain;
        best = j;
      }
    }
    return best;
  }

  /// Takes column j into the set. A column a_j = A_P mu that depends on the set pushes along (1, -mu), which leaves A x
  /// alone, until a member of the set is used up; if none is and c_j > mu.c_P beyond doubt, the descent never ends.
  [[nodiscard]] bool include(std::size_t j, std::vector<bool>& refused) {
    if (basis_.grow(problem_.columns[j], errors_.given)) {
      chosen_.push_back(j);
      return true;
    }
    using std::abs;
    const std::vector<W> mu = basis_.in_terms_of_the_others();
    std::size_t out = mu.size();
    W step(0), gain(problem_.c[j]), doubt(doubt_of(j));
    for (std::size_t k = 0; k < mu.size(); ++k) {
      const std::size_t i = chosen_[k];
      gain = gain - mu[k] * problem_.c[i];
      doubt = doubt + abs(mu[k]) * doubt_of(i);
      if (mu[k] > errors_.given && (out == mu.size() || W(x_[i] / mu[k]) < step)) {
        step = x_[i] / mu[k];
        out = k;
      }
    }
    if (!(gain > doubt)) {
      refused[j] = true;
      return true;
    }
    if (out == mu.size()) return false;
    for (std::size_t k = 0; k < mu.size(); ++k) x_[chosen_[k]] = x_[chosen_[k]] - step * mu[k];
    exclude(out);
    if (basis_.grow(problem_.columns[j], W(0))) {  // a_j has a part along the one that left
      chosen_.push_back(j);
      x_[j] = step;
    }
    return true;
  }

  [[nodiscard]] W doubt_of(std::size_t j) const { return problem_.slack[j] + errors_.given * problem_.size[j] + noise_; }

  /// The minimum over the set, cutting it down as long as a member would have to pull.
  void descend(std::size_t newest, std::vector<bool>& refused) {
    while (!chosen_.empty()) {
      const std::vector<W> s = basis_.solve_normal(c_of_the_set());
      std::size_t out = s.size();
      W part(1);
      for (std::size_t k = 0; k < s.size(); ++k)
        if (!(s[k] > 0)) {
          const W x = x_[chosen_[k]];
          const W reach = x > 0 ? W(x / (x - s[k])) : W(0);
          if (out == s.size() || reach < part) {
            part = reach;
            out = k;
          }
        }
      if (out == s.size()) {
        for (std::size_t k = 0; k < s.size(); ++k) x_[chosen_[k]] = s[k];
        if (!refused[newest]) std::fill(refused.begin(), refused.end(), false);
        return;
      }
      for (std::size_t k = 0; k < s.size(); ++k) {
        W& x = x_[chosen_[k]];
        x = x + part * (s[k] - x);
        if (!(x > 0)) x = W(0);
      }
      if (chosen_[out] == newest) refused[newest] = true;  // its gain was rounding
      exclude(out);
    }
  }

  void exclude(std::size_t k) {
    x_[chosen_[k]] = W(0);
    chosen_.erase(chosen_.begin() + static_cast<std::ptrdiff_t>(k));
    basis_.cut(k);
    std::vector<std::size_t> later(chosen_.begin() + static_cast<std::ptrdiff_t>(k), chosen_.end());
    chosen_.resize(k);
    for (const std::size_t j : later)
      if (basis_.grow(problem_.columns[j], W(0))) chosen_.push_back(j);
  }

  [[nodiscard]] std::vector<W> c_of_the_set() const {
    std::vector<W> c;
    for (const std::size_t j : chosen_) c.push_back(problem_.c[j]);
    return c;
  }

  /// One step of s += (R^T R)^-1 (c - A^T A s), which makes good what the factors lost.
  void refine() {
    const std::vector<W> p = product();
    std::vector<W> rest = c_of_the_set();
    for (std::size_t k = 0; k < rest.size(); ++k) rest[k] = rest[k] - inner(problem_.columns[chosen_[k]], p);
    const std::vector<W> s = basis_.solve_normal(std::move(rest));
    for (std::size_t k = 0; k < s.size(); ++k) {
      const W better = x_[chosen_[k]] + s[k];
      if (better > 0) x_[chosen_[k]] = better;
    }
  }

  const PushProblem<W>& problem_;
  PushErrors<W> errors_;
  W noise_{0};  // what the largest terms leave on all others
  std::vector<W> x_;
  std::vector<std::size_t> chosen_;
  OrthogonalBasis<W> basis_;
};

}  // namespace detail

/// A minimiser of (6), or nothing if there is no minimum. A x is unique, x only if the columns that matter are independent.
template <class W>
[[nodiscard]] std::optional<std::vector<W>> least_pushes(const PushProblem<W>& problem, const PushErrors<W>& errors) {
  if (problem.count() == 0) return std::vector<W>{};
  detail::ActiveSet<W> set(problem, errors);
  if (!set.solve()) return std::nullopt;
  return set.x();
}

/// Of all x' >= 0 with A x' = A x the one of least |x'|: it does not depend on the order of the columns. The equality is
/// weighted by 2^24 against each x', so x' is off by about 2^-48 / (smallest singular value of A that is not 0)^2.
template <class W>
[[nodiscard]] std::vector<W> evenly_spread(const PushProblem<W>& problem, const std::vector<W>& x,
                                           const PushErrors<W>& errors) {
  using std::sqrt;
  const W weight(0x1p24), length = sqrt(W(weight * weight + W(1)));
  const std::size_t n = problem.count(), rows = problem.columns.front().size();
  std::vector<W> p(rows, W(0));
  for (std::size_t j = 0; j < n; ++j) detail::subtract(p, W(-x[j]), problem.columns[j]);
  PushProblem<W> spread;
  for (std::size_t j = 0; j < n; ++j) {
    std::vector<W> column(rows + n, W(0));
    for (std::size_t i = 0; i < rows; ++i) column[i] = weight * problem.columns[j][i] / length;
    column[rows + j] = W(1) / length;
    spread.columns.push_back(std::move(column));
    spread.c.push_back(weight * weight * detail::inner(problem.columns[j], p) / length);
    spread.slack.push_back(W(0));
    spread.size.push_back(W(0));
  }
  detail::ActiveSet<W> set(spread, errors);
  if (!set.solve()) return x;
  std::vector<W> out = set.x();
  for (W& value : out) value = value / length;
  return out;
}

}  // namespace carom
