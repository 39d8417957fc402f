#pragma once
// The contacts of a cluster in wide arithmetic: how fast they close, and the least pushes that stop them.

#include <algorithm>
#include <numeric>
#include <optional>
#include <vector>

#include "carom/law/cluster.hpp"
#include "carom/law/impact.hpp"
#include "carom/law/least_pushes.hpp"

namespace carom::detail {

/// Errors relative to the terms of a sum: of a few operations in wide arithmetic, of a solve, and of directions that were
/// computed from positions in Real.
template <class Real>
[[nodiscard]] Real few_operations() {
  if constexpr (std::is_same_v<Real, double>) {
    return 0x1p-101;
  } else {
    return Real(unit_roundoff<Real>() * 8);
  }
}
template <class Real>
[[nodiscard]] Real a_solve() {
  return few_operations<Real>() * 512;
}
template <class Real>
[[nodiscard]] PushErrors<Wide<Real>> push_errors() {
  return {Wide<Real>(a_solve<Real>()), Wide<Real>(unit_roundoff<Real>() * 512)};
}

/// Velocities of all bodies in wide arithmetic, each component with a bound on its error.
template <class Real, int D>
struct WideMotion {
  std::vector<std::array<Wide<Real>, D>> v;
  std::vector<std::array<Real, D>> error;
};

/// What a set of impulses does, besides changing velocities.
template <class Real>
struct Impulses {
  std::vector<Wide<Real>> k;       // of each contact: the change of the relative velocity is k r, the impulse k mu |r|
  std::vector<Wide<Real>> evenly;  // the same velocities from the impulses of least sum of squares
  Wide<Real> dissipated{Real(0)};
};

/// A cluster as its contacts see it. Equations: papers/simultaneous.md.
template <class Real, int D>
class ClusterContacts {
  using W = Wide<Real>;

 public:
  using Set = std::vector<std::size_t>;  // numbers of contacts
  using Motion = WideMotion<Real, D>;

  struct Link {
    std::array<W, D> r;
    W rr{Real(0)}, share_a{Real(0)}, share_b{Real(0)}, mu{Real(0)};
    bool fixed = false;
  };

  explicit ClusterContacts(const Cluster<Real, D>& cluster) : cluster_(cluster) {
    for (const auto& c : cluster.contacts) {
      CAROM_EXPECT(c.a != c.b && c.a < cluster.bodies.size() && c.b < cluster.bodies.size());
      const Real &ma = cluster.bodies[c.a].mass, &mb = cluster.bodies[c.b].mass;
      Link link;
      link.r = c.r;
      if constexpr (D == 1) link.r[0] = narrow(c.r[0]) > 0 ? W(Real(1)) : W(Real(-1));
      link.rr = W(Real(0));
      for (int i = 0; i < D; ++i) link.rr = link.rr + link.r[i] * link.r[i];
      link.fixed = infinite(ma) && infinite(mb);
      if (!link.fixed) {
        link.share_a = share(ma, mb);
        link.share_b = share(mb, ma);
        link.mu = infinite(ma) ? W(mb) : link.share_a * W(ma);
      }
      links_.push_back(link);
    }
  }

  [[nodiscard]] const Link& link(std::size_t j) const { return links_[j]; }
  [[nodiscard]] std::size_t size() const { return links_.size(); }
  [[nodiscard]] bool moves(std::size_t body) const { return !infinite(cluster_.bodies[body].mass); }

  /// The contacts of `set`, parted into sets that no chain of finite bodies connects.
  [[nodiscard]] std::vector<Set> connected(const Set& set) const {
    std::vector<std::size_t> parent(cluster_.bodies.size());
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    const auto root = [&](std::size_t i) {
      while (parent[i] != i) i = parent[i] = parent[parent[i]];
      return i;
    };
    for (const std::size_t j : set) {
      const auto& c = cluster_.contacts[j];
      if (moves(c.a) && moves(c.b)) parent[root(c.a)] = root(c.b);
    }
    std::vector<Set> parts;
    std::vector<std::size_t> part_of(cluster_.bodies.size(), set.size());
    for (const std::size_t j : set) {
      const auto& c = cluster_.contacts[j];
      std::size_t fresh = set.size();
      std::size_t& part = links_[j].fixed ? fresh : part_of[root(moves(c.a) ? c.a : c.b)];
      if (part == set.size()) {
        part = parts.size();
        parts.emplace_back();
      }
      parts[part].push_back(j);
    }
    return parts;
  }

  /// c_j = (v_a - v_b).r, the sum of the sizes of its terms, and a bound on its error.
  struct Rate {
    W c{Real(0)};
    Real size{0}, slack{0};
  };
  [[nodiscard]] Rate approach(std::size_t j, const Motion& m) const {
    using std::abs;
    const auto& contact = cluster_.contacts[j];
    Rate out;
    for (int i = 0; i < D; ++i) {
      const W &va = m.v[contact.a][i], &vb = m.v[contact.b][i], &r = links_[j].r[i];
      out.c = out.c + (va - vb) * r;
      const Real size = abs(narrow(r)) * (abs(narrow(va)) + abs(narrow(vb)));
      out.size += size;
      out.slack += abs(narrow(r)) * (m.error[contact.a][i] + m.error[contact.b][i]) + few_operations<Real>() * size;
    }
    return out;
  }
  [[nodiscard]] bool approaches(std::size_t j, const Motion& m) const {
    const Rate rate = approach(j, m);
    return rate.c > W(rate.slack);
  }
  /// Faster than what the directions are in doubt by explains.
  [[nodiscard]] bool surely_approaches(std::size_t j, const Motion& m) const {
    const Rate rate = approach(j, m);
    return rate.c > W(rate.slack) + push_errors<Real>().given * W(rate.size);
  }

  /// The columns and rates of (6) for a connected set.
  [[nodiscard]] PushProblem<W> problem_of(const Set& set, const Motion& m) const {
    std::vector<std::size_t> row(cluster_.bodies.size(), 0), bodies;
    for (const std::size_t j : set)
      for (const std::size_t body : {cluster_.contacts[j].a, cluster_.contacts[j].b})
        if (moves(body) && std::find(bodies.begin(), bodies.end(), body) == bodies.end()) {
          row[body] = D * bodies.size();
          bodies.push_back(body);
        }
    PushProblem<W> problem;
    for (const std::size_t j : set) {
      using std::sqrt;
      const auto& contact = cluster_.contacts[j];
      const Link& link = links_[j];
      std::vector<W> column(D * bodies.size(), W(Real(0)));
      const W length = sqrt(link.rr), root_a = sqrt(link.share_a), root_b = sqrt(link.share_b);
      for (std::size_t i = 0; i < D; ++i) {
        if (moves(contact.a)) column[row[contact.a] + i] = root_a * link.r[i] / length;
        if (moves(contact.b)) column[row[contact.b] + i] = -(root_b * link.r[i] / length);
      }
      const Rate rate = approach(j, m);
      const W scale = sqrt(W(link.mu / link.rr));
      problem.columns.push_back(std::move(column));
      problem.c.push_back(rate.c * scale);
      problem.slack.push_back(W(rate.slack) * scale);
      problem.size.push_back(W(rate.size) * scale);
    }
    return problem;
  }

  /// The least pushes that end all approach in a connected set (5), times `factor`, given to `m` and added to `given`.
  /// False: there are none.
  [[nodiscard]] bool end_approach(const Set& set, const Real& factor, Motion& m, Impulses<Real>& given) const {
    using std::sqrt;
    if (set.size() == 1) {
      const std::size_t j = set.front();
      const W k = W(factor) * approach(j, m).c / links_[j].rr;
      if (!(k > 0)) return true;
      push(j, k, few_operations<Real>(), m);
      given.k[j] = given.k[j] + k;
      given.evenly[j] = given.evenly[j] + k;
      return true;
    }
    const PushProblem<W> problem = problem_of(set, m);
    const std::optional<std::vector<W>> x = least_pushes(problem, push_errors<Real>());
    if (!x) return false;
    const std::vector<W> evenly = spread(problem, *x);
    for (std::size_t i = 0; i < set.size(); ++i) {
      const std::size_t j = set[i];
      const W per_x = W(factor) / sqrt(W(links_[j].mu * links_[j].rr));
      const W k = (*x)[i] * per_x;
      given.k[j] = given.k[j] + k;
      given.evenly[j] = given.evenly[j] + evenly[i] * per_x;
      if (k > 0) push(j, k, few_operations<Real>(), m);
    }
    doubt(set, problem, *x, factor, m);
    return true;
  }

  /// sum m |v - u|^2 / 2 over the finite bodies of a part.
  [[nodiscard]] W half_square(const Set& part, const Motion& u, const Motion& v) const {
    W sum(Real(0));
    std::vector<bool> seen(cluster_.bodies.size(), false);
    for (const std::size_t j : part)
      for (const std::size_t body : {cluster_.contacts[j].a, cluster_.contacts[j].b}) {
        if (seen[body] || !moves(body)) continue;
        seen[body] = true;
        W square(Real(0));
        for (int i = 0; i < D; ++i) {
          const W change = v.v[body][i] - u.v[body][i];
          square = square + change * change;
        }
        sum = sum + square * W(cluster_.bodies[body].mass);
      }
    return sum * W(Real(1) / 2);
  }

  [[nodiscard]] Impulses<Real> none() const {
    Impulses<Real> out;
    out.k.assign(links_.size(), W(Real(0)));
    out.evenly = out.k;
    return out;
  }

  /// J.V of the infinite mass of a contact.
  [[nodiscard]] W work(std::size_t j, const W& k) const {
    const auto& contact = cluster_.contacts[j];
    const W per_length = k * links_[j].mu;
    W sum(Real(0));
    for (int i = 0; i < D; ++i) {
      const W impulse = per_length * links_[j].r[i];
      if (!moves(contact.a)) sum = sum + impulse * W(cluster_.bodies[contact.a].velocity[i]);
      if (!moves(contact.b)) sum = sum - impulse * W(cluster_.bodies[contact.b].velocity[i]);
    }
    return sum;
  }

 private:
  /// v_a -= s_a k r, v_b += s_b k r (2).
  void push(std::size_t j, const W& k, const Real& relative_error, Motion& m) const {
    using std::abs;
    const auto& contact = cluster_.contacts[j];
    for (int i = 0; i < D; ++i) {
      const W change = k * links_[j].r[i];
      const W da = links_[j].share_a * change, db = links_[j].share_b * change;
      m.v[contact.a][i] = m.v[contact.a][i] - da;
      m.v[contact.b][i] = m.v[contact.b][i] + db;
      m.error[contact.a][i] += relative_error * abs(narrow(da));
      m.error[contact.b][i] += relative_error * abs(narrow(db));
    }
  }

  /// A solve errs by a part of the whole change, sqrt(sum m |dv|^2) = |A x|: of a body's velocity by that over sqrt(m).
  void doubt(const Set& set, const PushProblem<W>& problem, const std::vector<W>& x, const Real& factor, Motion& m) const {
    using std::sqrt;
    std::vector<W> p(problem.columns.front().size(), W(Real(0)));
    for (std::size_t i = 0; i < set.size(); ++i) subtract(p, W(-x[i]), problem.columns[i]);
    const Real error = a_solve<Real>() * factor * sqrt(narrow(inner(p, p)));
    std::vector<bool> seen(cluster_.bodies.size(), false);
    for (const std::size_t j : set)
      for (const std::size_t body : {cluster_.contacts[j].a, cluster_.contacts[j].b}) {
        if (seen[body] || !moves(body)) continue;
        seen[body] = true;
        for (Real& e : m.error[body]) e += error / sqrt(cluster_.bodies[body].mass);
      }
  }

  /// Impulses of least sum of squares (11), which matters where columns depend on each other.
  [[nodiscard]] std::vector<W> spread(const PushProblem<W>& problem, const std::vector<W>& x) const {
    OrthogonalBasis<W> basis;
    bool independent = true;
    for (const auto& column : problem.columns) independent = independent && basis.grow(column, W(Real(1) / 1048576));
    if (independent) return x;
    return evenly_spread(problem, x, push_errors<Real>());
  }

  const Cluster<Real, D>& cluster_;
  std::vector<Link> links_;
};

}  // namespace carom::detail
