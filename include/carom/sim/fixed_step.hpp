#pragma once
// The fixed-step mode: the same scene, moved by time steps of one length, to measure against Simulation what a step costs.
//
// Balls, walls, space, masses, restitution and numbering are those of the event-driven mode. Gravity is integrated as game
// engines do, by semi-implicit Euler (v += a dt, then x += v dt), in all methods but `penalty`, which uses velocity Verlet.
// The law is restitution: scenes with law "stick" or "merge" are refused. Two infinite masses, or one and a wall, pass
// through each other. A two-sided wall (segment, polygon) acts towards the side that the centre of a ball is on: once the
// centre has passed, the ball is through; so `discrete` and `penalty` let points through such walls.
//
// What is reported as a collision (StepContact::impulse > 0):
//
// discrete, speculative: one for each unbroken run of steps in which the pair is found in contact, in the first of them
// that gives it an impulse, and with the impulse of that step. In its other steps the contact is reported with impulse 0.
//
// swept: every impact, at its own moment. But under acceleration an impact that follows one without restitution in the step
// before is a ball that rests, and has impulse 0.
//
// penalty: one for each contact, when it ends or has lasted twice the contact time, with the whole impulse and the deepest
// overlap up to then; nothing before. Its time is the end of that step, about the contact time after the balls first
// touched.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "carom/scene/scene.hpp"
#include "carom/sim/stepper.hpp"

namespace carom {

/// How much of an overlap is taken back at once, shared between the balls by inverse mass.
/// full: all of it. baumgarte: `fraction` of what exceeds the slop. none: nothing.
enum class PositionCorrection : std::uint8_t { full, baumgarte, none };

/// Gauss-Seidel passes over the contacts of a step, and what becomes of overlaps.
struct SolverOptions {
  int iterations = 1;  ///< passes, 1..1000
  PositionCorrection correction = PositionCorrection::full;
  double fraction = 0.2;   ///< baumgarte: [-] of the overlap taken back in a pass, 0..1. DEFAULT: 0.2
  double slop = 0.01;      ///< baumgarte: [radius of the smaller ball] overlap left alone, >= 0. DEFAULT: 0.01
  double threshold = 0.0;  ///< [length/time] pairs that approach more slowly get restitution 0, >= 0. DEFAULT: 0

  friend bool operator==(const SolverOptions&, const SolverOptions&) = default;
};

/// The discrete loop: all balls move by dt; overlapping pairs that approach get an impulse; overlaps are taken back.
/// DEFAULT: 1 pass, full correction.
struct DiscreteOptions {
  SolverOptions solver{};

  friend bool operator==(const DiscreteOptions&, const DiscreteOptions&) = default;
};

/// once: a ball has one contact in a step, its first, and flies on without looking. substeps: all contacts, in order, up to
/// `limit`.
enum class Sweep : std::uint8_t { once, substeps };

/// Continuous detection inside the step: contact times in closed form along the straight paths of the step.
struct SweptOptions {
  Sweep sweep = Sweep::once;  ///< DEFAULT: once
  int limit = 100;            ///< substeps: contacts of a ball in a step, then it flies on, 1..1000000. DEFAULT: 100
  double threshold = 0.0;     ///< [length/time] pairs that approach more slowly get restitution 0, >= 0. DEFAULT: 0

  friend bool operator==(const SweptOptions&, const SweptOptions&) = default;
};

/// Speculative contacts: no pair may close more than its gap within the step; restitution after the move [Catto2013].
/// DEFAULT: 8 passes, Baumgarte correction.
struct SpeculativeOptions {
  SolverOptions solver{8, PositionCorrection::baumgarte};

  friend bool operator==(const SpeculativeOptions&, const SpeculativeOptions&) = default;
};

/// Soft balls: a linear spring and dashpot while they overlap [CundallStrack1979; Luding1998], velocity Verlet. Overlaps
/// reach |v_n| t_c / pi. The restitution of an impact is off by at most 0.05 for t_c = 20 dt and 0.01 for 100 dt
/// (conservation_test, Penalty).
struct PenaltyOptions {
  std::optional<double> contact_time{};  ///< [time] of an impact, > 0. DEFAULT: steps * dt
  double steps = 20.0;                   ///< [dt] contact time where none is given, > 0. DEFAULT: 20

  friend bool operator==(const PenaltyOptions&, const PenaltyOptions&) = default;
};

using StepMethodOptions = std::variant<DiscreteOptions, SweptOptions, SpeculativeOptions, PenaltyOptions>;

/// An impact of the penalty method must last so many steps at least: below, its spring is not stable.
inline constexpr double least_contact_steps = 4.0;

struct FixedStepOptions {
  double dt = 0.0;             ///< [time] of a step, > 0 and finite. It must be given
  StepMethodOptions method{};  ///< DEFAULT: discrete
};

/// A method written as name[:option[=value]]..., for instance "discrete:iterations=8:correction=baumgarte".
///   discrete     iterations=N  correction=full|baumgarte|none  fraction=F  slop=S  threshold=V
///   swept        substeps  limit=N  threshold=V
///   speculative  as discrete
///   penalty      contact_time=T or steps=N
/// Throws InputError that names the known methods or options, and all that is wrong with the values.
[[nodiscard]] StepMethodOptions parse_step_method(std::string_view text);

/// The shortest text that parses to the same method; "discrete" with all its defaults.
[[nodiscard]] std::string step_method_text(const StepMethodOptions& method);

/// Names of the methods: "discrete", "swept", "speculative", "penalty".
[[nodiscard]] const std::vector<std::string>& step_method_names();

/// The scene at its start, ready to step. Throws InputError with every problem: of the scene, of dt, of the method's
/// options, and of a law that the fixed-step mode does not have.
[[nodiscard]] std::unique_ptr<Stepper> make_stepper(const Scene& scene, const FixedStepOptions& options);

}  // namespace carom
