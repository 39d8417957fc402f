#include "judge_scene.hpp"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "carom/core/error.hpp"
#include "carom/scene/read.hpp"
#include "carom/sim/simulation.hpp"
#include "rounding_books.hpp"
#include "sim/scenes.hpp"
#include "wedged.hpp"

namespace carom::testing {

namespace {

constexpr std::int64_t between_audits = 10;

/// On which side of a closed polygon: by the crossings of a ray.
[[nodiscard]] bool inside(const WallSpec& polygon, const std::vector<Number>& x) {
  bool in = false;
  const auto& v = polygon.vertices;
  for (std::size_t i = 0, j = v.size() - 1; i < v.size(); j = i++)
    if ((v[i][1] > x[1]) != (v[j][1] > x[1]) &&
        x[0] < (v[j][0] - v[i][0]) * (x[1] - v[i][1]) / (v[j][1] - v[i][1]) + v[i][0])
      in = !in;
  return in;
}

[[nodiscard]] bool dissipates(const Scene& scene) {
  bool soft = scene.collision.law != LawKind::restitution || scene.collision.restitution.value < 1 ||
              (scene.space.restitution && scene.space.restitution->value < 1);
  for (const WallSpec& w : scene.walls) soft = soft || (w.restitution && w.restitution->value < 1);
  return soft;
}

/// Between two bodies that do not yield, elastic impacts need not end either.
[[nodiscard]] bool can_be_pressed(const Scene& scene) {
  bool rigid = !scene.motion.acceleration.empty();
  for (const BallSpec& b : scene.balls) rigid = rigid || b.fixed || std::isinf(b.mass.value);
  for (const WallSpec& w : scene.walls) rigid = rigid || !w.velocity.empty();
  return rigid;
}

class Judge {
 public:
  Judge(const Scene& scene, const std::atomic<bool>& interrupt)
      : scene_(scene), interrupt_(interrupt), simulation_(scene), rounding_(scene, simulation_), sides_(sides()) {
    for (const BallSpec& b : scene.balls) {
      double square = 0.0;
      for (const double v : b.velocity) square += v * v;
      if (!std::isinf(b.mass.value) && !b.fixed) momentum_ += b.mass * std::sqrt(square);
    }
  }

  [[nodiscard]] Verdict judge() {
    std::vector<Collision> log;
    Stop stop = Stop::events;
    while (stop == Stop::events && verdict_.collisions < most_collisions && verdict_.complaint.empty()) {
      stop = simulation_.advance(
          scene_.run.until, between_audits,
          [&](const Collision& c) {
            log.push_back(c);
            rounding_.record(c);
          },
          &interrupt_);
      verdict_.collisions = simulation_.counts().collisions();
      look(stop);
    }
    if (verdict_.complaint.empty()) compare(log, stop);
    return std::move(verdict_);
  }

 private:
  template <class... Args>
  void complain(fmt::format_string<Args...> format, Args&&... args) {
    if (verdict_.complaint.empty())
      verdict_.complaint = fmt::format(format, std::forward<Args>(args)...) +
                           fmt::format(" (after {} collisions, at time {})", verdict_.collisions, simulation_.time());
  }

  /// Which polygons each ball is in.
  [[nodiscard]] std::vector<std::pair<std::uint32_t, bool>> sides() const {
    std::vector<std::pair<std::uint32_t, bool>> out;
    for (const WallSpec& w : scene_.walls)
      if (w.kind == WallKind::polygon && scene_.space.kind != SpaceKind::periodic)
        for (const BallState& b : simulation_.balls())
          if (b.radius > 0 && !std::isinf(b.mass.value)) out.emplace_back(b.index, inside(w, b.position));
    return out;
  }

  void look(Stop stop) {
    if (stop == Stop::interrupted) complain("the run does not end");
    if (stop == Stop::non_finite) complain("a number is not finite");
    const Summary s = simulation_.summary();
    if (stop == Stop::collapse && !dissipates(scene_) && !can_be_pressed(scene_) && !wedged(scene_, simulation_))
      complain("elastic, but given up: {}", s.stopped ? s.stopped->reason : "");
    for (const BallState& b : simulation_.balls())
      for (std::size_t k = 0; k < b.position.size(); ++k)
        if (!std::isfinite(b.position[k].value) || !std::isfinite(b.velocity[k].value))
          complain("ball {} is nowhere", b.index);
    if (s.exactness.clamped != 0) complain("{} events in the past", s.exactness.clamped);
    judge_energy(s.energy);
    if (s.momentum.relative_error && *s.momentum.relative_error != 0.0)
      judge_momentum(*s.momentum.relative_error * momentum_);
    if (stop == Stop::collapse) return;  // what stops a run may leave a ball where it cannot stay
    // In the middle of an instant a merged ball may overlap what it will merge with.
    if (scene_.collision.law == LawKind::merge && stop == Stop::events) return;
    const Audit audit = simulation_.audit(AuditBy::every_pair);
    if (audit.overlaps != 0)
      complain("{} overlaps, the deepest {:.3g} of ball {} and {} {}", audit.overlaps, audit.deepest, audit.ball,
               audit.with_wall ? "wall" : "ball", audit.partner);
    if (scene_.collision.law == LawKind::restitution && sides() != sides_) complain("a ball went through a polygon");
  }

  void judge_energy(const EnergyBalance& e) {
    const double error = std::abs((e.final.value - e.initial.value) + (e.dissipated.value - e.injected.value));
    const double bound = rounding_.energy(simulation_, e);
    if (bound > 0) verdict_.energy_error = std::max(verdict_.energy_error, error / bound);
    if (!(error <= bound)) complain("energy is off by {:.3g} where rounding explains {:.3g}", error, bound);
  }

  void judge_momentum(double error) {
    const double bound = rounding_.momentum(simulation_);
    verdict_.momentum_error = std::max(verdict_.momentum_error, error / bound);
    if (!(error <= bound)) complain("momentum is off by {:.3g} where rounding explains {:.3g}", error, bound);
  }

  void compare(const std::vector<Collision>& log, Stop stop) {
    Simulation other = Simulation::reference(scene_);
    std::vector<Collision> log_of_other;
    const Stop stop_of_other = other.advance(
        scene_.run.until, static_cast<std::int64_t>(log.size()), [&](const Collision& c) { log_of_other.push_back(c); },
        &interrupt_);
    const std::string first = difference(log, log_of_other);
    if (!first.empty()) complain("another queue and search give another log: {}", first);
    if (stop_of_other != stop && stop_of_other != Stop::events)
      complain("it ends with {}, another queue and search with {}", word(stop), word(stop_of_other));
  }

  const Scene& scene_;
  const std::atomic<bool>& interrupt_;
  Simulation simulation_;
  RoundingBooks rounding_;
  std::vector<std::pair<std::uint32_t, bool>> sides_;
  double momentum_ = 0.0;  // sum of m |v| at the start
  Verdict verdict_;
};

}  // namespace

Verdict judge_scene(const std::string& text, const std::atomic<bool>& interrupt) {
  Verdict refused;
  refused.refused = true;
  try {
    const Scene scene = read_scene(text, "any.toml");
    return Judge(scene, interrupt).judge();
  } catch (const InputError&) {
    return refused;
  } catch (const std::exception& error) {
    Verdict thrown;
    thrown.complaint = fmt::format("an exception: {}", error.what());
    return thrown;
  }
}

}  // namespace carom::testing
