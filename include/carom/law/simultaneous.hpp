#pragma once
// All contacts of bodies that touch at one instant, at once: generalised reflections, and the plastic impact beside them.

#include <algorithm>
#include <numeric>
#include <vector>

#include "carom/law/cluster_contacts.hpp"
#include "carom/law/settle.hpp"

namespace carom {
namespace detail {

/// One cluster, whose connected parts are resolved one after another. Equations: papers/simultaneous.md.
template <class Real, int D>
class ClusterImpact {
  using W = Wide<Real>;
  using Contacts = ClusterContacts<Real, D>;
  using Set = typename Contacts::Set;
  using Motion = typename Contacts::Motion;

 public:
  explicit ClusterImpact(const Cluster<Real, D>& cluster)
      : cluster_(cluster), contacts_(cluster), before_(as_given(cluster)) {}

  [[nodiscard]] ClusterOutcome<Real, D> resolve() {
    for (const auto& body : cluster_.bodies) out_.velocities.push_back(body.velocity);
    out_.impulses.assign(contacts_.size(), Real(0));
    Set all(contacts_.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    for (const Set& part : contacts_.connected(all)) resolve_part(part);
    return std::move(out_);
  }

 private:
  [[nodiscard]] static Motion as_given(const Cluster<Real, D>& cluster) {
    Motion m;
    for (const auto& body : cluster.bodies) {
      std::array<W, D> v;
      std::array<Real, D> error;
      for (int i = 0; i < D; ++i) {
        v[i] = W(body.velocity[i]);
        error[i] = Real(0);
      }
      m.v.push_back(v);
      m.error.push_back(error);
    }
    return m;
  }

  /// (5) for all contacts of the part.
  [[nodiscard]] bool plastic(const Set& part, Motion& m, Impulses<Real>& given) const {
    if (!contacts_.end_approach(part, Real(1), m, given)) return false;
    given.dissipated = contacts_.half_square(part, before_, m);
    return true;
  }

  enum class End { done, crushed, cut_short };

  [[nodiscard]] static bool is_among(const Set& set, std::size_t j) {
    return std::find(set.begin(), set.end(), j) != set.end();
  }

  /// Generalised reflections (7), (8). `met`: contacts that approached at some stage.
  [[nodiscard]] End reflect(const Set& part, Motion& m, Impulses<Real>& given, std::vector<bool>& met, Set& pinned) {
    const auto look_for_pins = static_cast<std::int64_t>(part.size()) + 8;
    for (std::int64_t n = 0; n < most_reflections; ++n) {
      Set violated;
      for (const std::size_t j : part)
        if (is_among(pinned, j) ? contacts_.surely_approaches(j, m) : contacts_.approaches(j, m)) {
          violated.push_back(j);
          met[j] = true;
        }
      if (violated.empty()) return End::done;
      if (n == look_for_pins) {
        Motion trial = before_;
        Impulses<Real> unused = contacts_.none();
        if (!plastic(part, trial, unused)) return End::crushed;
        pinned = pinned_among(part);
        if (!pinned.empty()) {
          m = before_;
          given = contacts_.none();
          for (const Set& set : contacts_.connected(pinned))
            if (!contacts_.end_approach(set, Real(1), m, given)) return End::crushed;
          given.dissipated = contacts_.half_square(part, before_, m);
          continue;
        }
      }
      Set pushed = violated;
      for (const std::size_t j : pinned)
        if (!is_among(violated, j)) pushed.push_back(j);
      std::sort(pushed.begin(), pushed.end());
      for (const Set& set : contacts_.connected(pushed)) {
        const auto hit = [&](std::size_t j) { return is_among(violated, j); };
        if (std::none_of(set.begin(), set.end(), hit)) continue;
        if (!contacts_.end_approach(set, Real(2), m, given)) return End::crushed;
      }
      ++out_.reflections;
    }
    return End::cut_short;
  }

  /// What the infinite masses add to c, in proportion to the fastest: one a contact.
  [[nodiscard]] std::vector<W> wall_rates(const Set& part) const {
    using std::abs;
    using std::sqrt;
    std::vector<W> rates;
    Real fastest(0);
    for (const std::size_t j : part) {
      const auto& contact = cluster_.contacts[j];
      const auto& link = contacts_.link(j);
      W rate(Real(0));
      for (int i = 0; i < D; ++i) {
        if (!contacts_.moves(contact.a)) rate = rate + W(cluster_.bodies[contact.a].velocity[i]) * link.r[i];
        if (!contacts_.moves(contact.b)) rate = rate - W(cluster_.bodies[contact.b].velocity[i]) * link.r[i];
      }
      rates.push_back(rate * sqrt(W(link.mu / link.rr)));
      if (abs(narrow(rates.back())) > fastest) fastest = abs(narrow(rates.back()));
    }
    if (fastest > 0)
      for (W& rate : rates) rate = rate / W(fastest);
    return rates;
  }

  /// The contacts i for which sum_j mu_j (n_j, V_j.n_j) = 0 with mu >= 0 and mu_i > 0 (9): no motion opens them. Found a
  /// support at a time; what lies in the span of those found is pinned with them, and the search goes on across it.
  [[nodiscard]] Set pinned_among(const Set& part) const {
    using std::sqrt;
    const PushErrors<W> errors = push_errors<Real>();
    std::vector<std::vector<W>> columns = contacts_.problem_of(part, before_).columns;
    const std::vector<W> rates = wall_rates(part);
    for (std::size_t i = 0; i < part.size(); ++i) columns[i].push_back(rates[i]);
    OrthogonalBasis<W> span;
    Set open(part.size()), pinned;
    std::iota(open.begin(), open.end(), std::size_t{0});
    while (!open.empty()) {
      PushProblem<W> sum_to_one;  // |N mu|^2 + (1 - sum mu)^2
      Set still_open;
      for (const std::size_t i : open) {
        const W length = span.part_across(columns[i]);
        if (!(length > errors.given)) {
          pinned.push_back(part[i]);
          continue;
        }
        still_open.push_back(i);
        std::vector<W> column = columns[i];
        for (W& x : column) x = x / length;
        column.push_back(W(Real(1)));
        const W norm = sqrt(inner(column, column));
        for (W& x : column) x = x / norm;
        sum_to_one.c.push_back(column.back());
        sum_to_one.slack.push_back(errors.given);
        sum_to_one.size.push_back(W(Real(1)));
        sum_to_one.columns.push_back(std::move(column));
      }
      open = still_open;
      const std::optional<std::vector<W>> mu = least_pushes(sum_to_one, errors);
      if (open.empty() || !mu) break;
      std::vector<W> sum(sum_to_one.columns.front().size(), W(Real(0)));
      for (std::size_t i = 0; i < open.size(); ++i) subtract(sum, W(-(*mu)[i]), sum_to_one.columns[i]);
      sum.back() = W(Real(0));
      const W closest = errors.given * W(Real(16));
      if (inner(sum, sum) > closest * closest) break;
      bool found = false;
      for (std::size_t i = 0; i < open.size(); ++i)
        if ((*mu)[i] > 0) found = span.grow(columns[open[i]], errors.given) || found;
      if (!found) break;
    }
    std::sort(pinned.begin(), pinned.end());
    return pinned;
  }

  void resolve_part(const Set& part) {
    if (part.size() == 1) return resolve_one(part.front());
    Motion soft = before_, hard = before_;
    Impulses<Real> soft_given = contacts_.none(), hard_given = contacts_.none();
    std::vector<bool> met(contacts_.size(), false);
    Set pinned;
    const bool all_plastic =
        std::all_of(part.begin(), part.end(), [&](std::size_t j) { return cluster_.contacts[j].e == 0; });
    const End end = all_plastic ? End::done : reflect(part, hard, hard_given, met, pinned);
    Real e(all_plastic ? 0 : 1);  // the smallest of those that met (10)
    for (const std::size_t j : part)
      if (met[j] && cluster_.contacts[j].e < e) e = cluster_.contacts[j].e;
    const bool goes_on = e == 1 && pinned.empty();
    Set* const too_long = end != End::cut_short ? nullptr : goes_on ? &out_.unfinished : &out_.cut_short;
    if (too_long == &out_.cut_short) e = Real(0);
    if (end == End::crushed || (e != 1 && !plastic(part, soft, soft_given))) {
      out_.crushed.insert(out_.crushed.end(), part.begin(), part.end());
      return;
    }
    if (too_long != nullptr) too_long->insert(too_long->end(), part.begin(), part.end());
    out_.pinned.insert(out_.pinned.end(), pinned.begin(), pinned.end());
    blend(part, e, soft, soft_given, hard, hard_given);
  }

  /// v = (1 - e) v_soft + e v_hard (10), and its books (12).
  void blend(const Set& part, const Real& e, const Motion& soft, const Impulses<Real>& soft_given, const Motion& hard,
             const Impulses<Real>& hard_given) {
    using std::sqrt;
    const W of_soft = wide_difference<Real>(Real(1), e), of_hard(e);
    for (const std::size_t j : part) {
      for (const std::size_t body : {cluster_.contacts[j].a, cluster_.contacts[j].b}) {
        if (!contacts_.moves(body)) continue;
        for (int i = 0; i < D; ++i) {
          const W& u = soft.v[body][i];
          const W v = e == 1 ? hard.v[body][i] : e == 0 ? u : W(of_soft * u + of_hard * hard.v[body][i]);
          const Real error = e == 1 ? hard.error[body][i] : Real(soft.error[body][i] + hard.error[body][i]);
          out_.velocities[body][i] = settle(v, error);
        }
      }
      const W k = of_soft * soft_given.k[j] + of_hard * hard_given.k[j];
      const W evenly = of_soft * soft_given.evenly[j] + of_hard * hard_given.evenly[j];
      const W impulse = evenly * contacts_.link(j).mu * sqrt(contacts_.link(j).rr);
      out_.impulses[j] = narrow(impulse) > 0 ? narrow(impulse) : Real(0);
      out_.injected = out_.injected + contacts_.work(j, k);
    }
    out_.dissipated = out_.dissipated + of_soft * soft_given.dissipated + of_hard * hard_given.dissipated;
    if (e != 0 && e != 1) out_.dissipated = out_.dissipated + of_soft * of_hard * contacts_.half_square(part, soft, hard);
  }

  /// Alone, a contact is an impact of two bodies, to the bit.
  void resolve_one(std::size_t j) {
    const auto& contact = cluster_.contacts[j];
    const auto &a = cluster_.bodies[contact.a], &b = cluster_.bodies[contact.b];
    if (contacts_.link(j).fixed) {
      if (contacts_.approaches(j, before_)) out_.crushed.push_back(j);
      return;
    }
    const Outcome<Real, D> one = resolve_impact<Real, D>({contact.r, a.velocity, b.velocity, a.mass, b.mass, contact.e});
    out_.velocities[contact.a] = one.va;
    out_.velocities[contact.b] = one.vb;
    out_.impulses[j] = one.impulse;
    out_.dissipated = out_.dissipated + one.dissipated;
    out_.injected = out_.injected + one.injected;
    if (one.impulse > 0) ++out_.reflections;
  }

  const Cluster<Real, D>& cluster_;
  Contacts contacts_;
  Motion before_;
  ClusterOutcome<Real, D> out_;
};

}  // namespace detail

/// Velocities after all contacts of a cluster at once [papers/simultaneous.md]. Elastic: reflect in all contacts that
/// approach, together, until none does [Smith2012]; plastic: the nearest velocities at which none approaches [Moreau1988];
/// in between v = (1 - e) v_plastic + e v_elastic, e the smallest of the contacts that approached at some stage.
/// Parts that no chain of finite bodies connects do not see each other; one contact alone is `resolve_impact`.
/// Bodies and contacts may come in any order: the velocities are evaluated in wide arithmetic and settled once
/// (settle.hpp), so they are the same to the bit but for values within about 2^-40 ulp of where the rounding turns.
template <class Real, int D>
[[nodiscard]] ClusterOutcome<Real, D> resolve_cluster(const Cluster<Real, D>& cluster) {
  return detail::ClusterImpact<Real, D>(cluster).resolve();
}

}  // namespace carom
