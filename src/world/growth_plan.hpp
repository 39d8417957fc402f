#pragma once
// What growing balls come to: when they reach the packing fraction asked for, and when one of them fills its space.

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "carom/core/error.hpp"
#include "carom/scene/scene.hpp"
#include "carom/solve/polynomial.hpp"
#include "carom/world/placement/radius.hpp"
#include "carom/world/world.hpp"

namespace carom::detail {

/// Groups of balls alike, in the order of their numbers, are added; space and walls are those of a world that is otherwise
/// without balls yet.
template <class Real, int D>
class GrowthPlan {
 public:
  GrowthPlan(const Scene& scene, const World<Real, D>& world) : scene_(scene), world_(world) {}

  void add(std::size_t count, const Real& radius, const Real& rate, bool moves) {
    groups_.push_back({count, radius, rate});
    grows_ = grows_ || rate > 0;
    moves_ = moves_ || moves;
  }

  [[nodiscard]] Growth<Real> finished(std::vector<Problem>& problems) const {
    Growth<Real> growth;
    if (!grows_) return growth;
    for (const Group& g : groups_) growth.rates.insert(growth.rates.end(), g.count, g.rate);
    growth.full = moment(filling_time());
    const RunSpec& run = scene_.run;
    if (run.until_packing) growth.packed = moment(packing_time(Real(run.until_packing->value), problems));
    if (run.until_reduced_pressure) growth.pressure = Real(run.until_reduced_pressure->value);
    growth.rescale_every = run.rescale_every.value_or(0);
    if ((run.until_packing || run.until_reduced_pressure) && world_.space.kind == SpaceKind::open)
      complain(problems, run.until_packing ? "until_packing" : "until_reduced_pressure",
               "the space is open: it has no volume", "Give [space] a kind, lower and upper");
    if (run.rescale_every && !moves_)
      complain(problems, "rescale_every", "every ball is at rest at the start, so there is no energy to go back to",
               "Leave it out, or give the gas a temperature");
    return growth;
  }

 private:
  struct Group {
    std::size_t count;
    Real radius, rate;
  };

  [[nodiscard]] Time<Real> moment(const Real& flight) const {
    return flight == never<Real>() ? Time<Real>::never() : after(world_.start, flight);
  }
  void complain(std::vector<Problem>& problems, const char* key, std::string why, std::string hint) const {
    problems.push_back({scene_.file, scene_.run.where.line, fmt::format("run.{} cannot be reached", key), std::move(why),
                        std::move(hint)});
  }

  /// The first t at which phi V / c - sum (r + gamma t)^D falls through 0, with c the volume of a ball of radius 1.
  [[nodiscard]] Real packing_time(const Real& packing, std::vector<Problem>& problems) const {
    if (world_.space.kind == SpaceKind::open) return never<Real>();
    using W = Wide<Real>;
    const Real unit = Real(ball_volume(1.0, D));
    W room(packing);
    for (int k = 0; k < D; ++k) room = room * W(world_.space.edge[k]);
    std::array<W, D + 1> missing;
    missing.fill(W(Real(0)));
    missing[0] = room / W(unit);
    for (const Group& g : groups_) {
      const W n(static_cast<Real>(g.count)), r(g.radius), rate(g.rate);
      const std::array<W, 4> powers = {W(Real(1)), r, r * r, r * r * r};
      W term = n;  // n gamma^k
      Real ways(1);
      for (int k = 0; k <= D; ++k) {
        missing[k] = missing[k] - term * W(ways) * powers[D - k];
        ways = ways * Real(D - k) / Real(k + 1);
        term = term * rate;
      }
    }
    if (!(narrow(missing[0]) > 0)) {
      complain(problems, "until_packing", "the balls fill that share of the space, or more, at the start",
               "Start with less");
      return never<Real>();
    }
    return carom::first_fall(missing);
  }

  /// When the first ball meets its own image, two opposite faces, or a circle all round.
  [[nodiscard]] Real filling_time() const {
    Real first = never<Real>();
    const auto fills = [&](const Real& room) {
      for (const Group& g : groups_)
        if (g.rate > 0) first = std::min<Real>(first, room > g.radius ? Real((room - g.radius) / g.rate) : Real(0));
    };
    if (world_.space.kind != SpaceKind::open)
      for (int k = 0; k < D; ++k) fills(Real(world_.space.edge[k] / 2));
    for (const auto& sphere : world_.walls.spheres)
      if (sphere.inside) fills(sphere.radius);
    return first;
  }

  const Scene& scene_;
  const World<Real, D>& world_;
  std::vector<Group> groups_;
  bool grows_ = false, moves_ = false;
};

}  // namespace carom::detail
