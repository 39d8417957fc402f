#include "model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/core.h>

#include "carom/scene/exact_only.hpp"
#include "carom/scene/growing.hpp"
#include "carom/write/number_text.hpp"

namespace carom::app {

namespace {

std::string shown(const Number& number) { return number.text.empty() ? number_text(number.value) : number.text; }

std::string rule_between_balls(const CollisionSpec& collision) {
  switch (collision.law) {
    case LawKind::stick:
      return "balls stick: two bodies take their common velocity and are one from then on";
    case LawKind::merge:
      return "balls merge: one ball with the summed mass, momentum and volume";
    case LawKind::restitution:
      break;
  }
  const std::string kind = collision.restitution == 1.0 ? " (elastic)" : collision.restitution == 0.0 ? " (plastic)" : "";
  return fmt::format("e = {}{} along the normal, where nothing below says otherwise", shown(collision.restitution), kind);
}

bool dissipates(const Scene& scene) {
  const auto below = [](const auto& e) { return e < 1.0; };
  const auto of = [&](const auto& list) {
    return std::any_of(list.begin(), list.end(), [&](const auto& entry) { return below(entry.restitution); });
  };
  const auto at = [&](const std::optional<Number>& e) { return e && below(e->value); };
  return below(scene.collision.restitution.value) || of(scene.materials) || of(scene.material_pairs) ||
         at(scene.space.restitution) ||
         std::any_of(scene.walls.begin(), scene.walls.end(), [&](const WallSpec& w) { return at(w.restitution); });
}

bool accelerated(const Scene& scene) {
  const auto& g = scene.motion.acceleration;
  return std::any_of(g.begin(), g.end(), [](const Number& a) { return a != 0.0; });
}

std::vector<std::string> regularisation(const Scene& scene) {
  const CollisionSpec& c = scene.collision;
  std::vector<std::string> rules;
  if (c.regularise == Regularise::viscoelastic)
    rules.push_back(fmt::format("viscoelastic: each e holds at a speed of approach of {}; slower impacts are more elastic, "
                                "1 - e as v^(1/5), faster ones less",
                                shown(*c.reference_speed)));
  if (c.regularise == Regularise::rest && accelerated(scene))
    rules.push_back("a ball whose bounces on a flat wall end rests on it, and slides along it without friction, until it is "
                    "hit or the wall ends");
  if (c.contact_time.value > 0)
    rules.push_back(fmt::format("TC model: an impact is elastic if either ball's last contact is at most {} ago{}",
                                shown(c.contact_time),
                                c.regularise == Regularise::rest ? "; flat walls dissipate always" : ""));
  return rules;
}

}  // namespace

std::vector<std::string> collision_rules(const Scene& scene) {
  std::vector<std::string> rules{rule_between_balls(scene.collision)};
  for (const MaterialSpec& m : scene.materials) rules.push_back(fmt::format("{}: e = {}", m.name, shown(m.restitution)));
  for (const MaterialPairSpec& m : scene.material_pairs)
    rules.push_back(fmt::format("{} with {}: e = {}", m.first, m.second, shown(m.restitution)));
  if (scene.space.restitution) rules.push_back("faces of the box: e = " + shown(*scene.space.restitution));
  for (std::size_t i = 0; i < scene.walls.size(); ++i)
    if (scene.walls[i].restitution) rules.push_back(fmt::format("wall {}: e = {}", i, shown(*scene.walls[i].restitution)));
  if (balls_grow(scene))
    rules.push_back("radii grow: e is of the speed at which the surfaces approach, and growth does work, booked as injected");
  if (scene.run.rescale_every)
    rules.push_back(fmt::format("every {} collisions all velocities are scaled back to the kinetic energy of the start",
                                *scene.run.rescale_every));
  for (std::string& rule : regularisation(scene)) rules.push_back(std::move(rule));
  return rules;
}

std::vector<std::string> not_modelled(const Scene& scene) {
  std::vector<std::string> list{
      "rotation: balls have no spin, and impacts are smooth (no friction, no tangential impulse)",
      scene.collision.simultaneous == Simultaneous::symmetric
          ? "duration and deformation: an impact takes no time, and all contacts of one instant are resolved together "
            "[Smith2012]; stiffness, which decides in nature, is not asked for"
          : "duration and deformation: an impact takes no time, and three bodies that touch at once are resolved pair by pair",
      "air, rolling and sliding resistance, attraction, charge"};
  if (is_magnetic(scene)) {
    list.push_back("forces other than the magnetic field's, and currents or charges that would make one");
  } else if (!accelerated(scene)) {
    list.push_back("gravity: no force acts between impacts (give motion.acceleration for one)");
  } else {
    list.push_back("forces other than the uniform acceleration");
  }
  if (scene.dimension < 3)
    list.push_back(scene.dimension == 1 ? "directions beyond the line: balls are rods that cannot pass each other"
                                        : "the third dimension: balls are disks");
  return list;
}

std::vector<std::string> limits(const Scene& scene) {
  std::vector<std::string> list{
      "double precision: a contact time is the root of the exact equation, rounded; the summary reports the largest gap "
      "error",
      "chaos multiplies rounding errors at every impact: single trajectories part from the true ones after some tens of "
      "impacts of a ball, while conserved quantities and averages stay right"};
  if (is_magnetic(scene))
    list.push_back(
        "magnetic field: places on a circle and contact times take sines and arc tangents of this machine's library; another "
        "machine may differ in the last bit");
  if (std::any_of(scene.walls.begin(), scene.walls.end(), [](const WallSpec& w) { return w.oscillation.has_value(); }))
    list.push_back(
        "walls that swing: a contact time is the first root by a rigorous bracket, and the walls' places take sines of this "
        "machine's library; the same start at another time is another run, not the same bits shifted");
  if (std::any_of(scene.walls.begin(), scene.walls.end(), [](const WallSpec& w) {
        return w.kind == WallKind::ellipse || w.kind == WallKind::parabola || w.kind == WallKind::curve;
      }))
    list.push_back(
        "ellipses, parabolas and curves: where a contact time has no closed form (a ball of some radius, a curve r(theta), a "
        "magnetic field) it is the first root by a rigorous bracket, which takes sines of this machine's library");
  if (!dissipates(scene) || scene.collision.law != LawKind::restitution) return list;
  if (scene.collision.regularise == Regularise::rest && accelerated(scene)) {
    list.push_back(
        "a ball that comes to rest on another one, on a curved wall or in a corner is not held: such an inelastic collapse "
        "ends the run with status 3");
  } else if (scene.collision.contact_time.value == 0) {
    list.push_back(
        "restitution below 1: infinitely many impacts in finite time (inelastic collapse, a ball that comes to rest) "
        "end the run with status 3");
  }
  return list;
}

std::vector<std::string> limits_of_steps(const Scene& scene, const std::vector<BallState>& start) {
  if (balls_grow(scene)) return {"balls that grow: steps and engines keep the radii, and compare refuses them"};
  if (scene.collision.law != LawKind::restitution)
    return {"balls that stick or merge: the fixed-step mode has the law \"restitution\" alone, and compare needs it"};
  std::vector<std::string> beyond;
  for (const Problem& p : exact_only(scene)) beyond.push_back(p.what + ": " + p.why);
  if (!beyond.empty()) return beyond;
  std::vector<std::string> list{
      "the order of collisions within a step (all methods but swept:substeps take them as they come), and what follows"};
  const CollisionSpec& law = scene.collision;
  if (law.contact_time.value > 0)
    list.push_back("contact_time: steps and engines dissipate at every impact, however soon it follows another");
  if (law.regularise == Regularise::viscoelastic)
    list.push_back("viscoelastic restitution: steps and engines take e as it is given, at every speed");
  if (law.regularise == Regularise::rest)
    list.push_back("rest as a state: in steps and engines a ball goes on bouncing on the floor, or sinks, or is put to sleep");
  if (law.simultaneous == Simultaneous::symmetric)
    list.push_back("all contacts of one instant together: steps and engines take them one after another");
  double fastest = 0, smallest = std::numeric_limits<double>::infinity();
  bool points = false;
  for (const BallState& b : start) {
    double square = 0;
    for (const double v : b.velocity) square += v * v;
    fastest = std::max(fastest, std::sqrt(square));
    if (b.radius > 0) smallest = std::min(smallest, b.radius.value);
    points = points || b.radius == 0;
  }
  // Two balls of radius r overlap and still approach along 2 r of a head-on path, which closes at 2 v.
  if (start.size() > 1 && fastest > 0 && std::isfinite(smallest))
    list.push_back(
        fmt::format("discrete, penalty: all head-on hits only below dt = r/v = {:.3g}, with the smallest radius and the "
                    "largest speed of "
                    "the start; grazing hits leave less time, down to none",
                    smallest / fastest));
  const bool two_sided = std::any_of(scene.walls.begin(), scene.walls.end(), [](const WallSpec& w) {
    return w.kind == WallKind::segment || w.kind == WallKind::polygon;
  });
  if (points && two_sided)
    list.push_back(
        "discrete, penalty: balls of radius 0 at segments and polygons, which they pass without ever overlapping");
  const auto& g = scene.motion.acceleration;
  if (std::any_of(g.begin(), g.end(), [](const Number& a) { return a != 0.0; }))
    list.push_back(
        "a parabola: semi-implicit Euler is g t dt/2 off after a time t (penalty: velocity Verlet, exact between "
        "contacts)");
  return list;
}

}  // namespace carom::app
