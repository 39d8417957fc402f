#pragma once
// Game engines beside carom: the same scene in Box2D, Chipmunk or Bullet, with the settings that each recommends, stepped.
//
// Walls are numbered as Simulation does. Hard smooth balls: no friction, no damping, no rotation. Every contact is given
// the restitution that carom looks up for it, in place of the engine's own mixing.
//
// Lengths and masses are multiplied by powers of two, so that the median radius lies in the range that the engine's
// settings are made for: [1/2, 1) in Box2D and Bullet (metres), [16, 32) in Chipmunk (pixels); the median mass in [1/2, 1).
// One unit of the scene's time is one second. Results are in the user's units.
//
// What is reported as a collision (StepContact::impulse > 0): once for each unbroken run of steps in which the engine has
// the pair in contact, in the first of them that gives it an impulse, and with the impulse of that step. In the other steps
// the contact is reported with impulse 0.

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "carom/scene/scene.hpp"
#include "carom/sim/stepper.hpp"

namespace carom {

/// A game engine that carom knows, whether or not this carom was built with it.
struct GameEngine {
  std::string name{};       ///< as it is written: "box2d", "chipmunk", "bullet"
  std::string version{};    ///< compiled against; empty if not built
  std::string package{};    ///< Debian package that it is built from: "libbox2d-dev"
  bool built = false;       ///< this carom has it
  bool continuous = false;  ///< knows the option `continuous`
  std::string settings{};   ///< the settings that it is run with, in sentences
};

/// All known engines, in a fixed order.
[[nodiscard]] const std::vector<GameEngine>& game_engines();

struct GameEngineOptions {
  std::string engine{};  ///< a name among game_engines(). It must be given
  double dt = 0.0;       ///< [time] of a step, > 0 and finite. It must be given
  /// The engine's continuous collision detection for balls: Box2D "bullet" bodies; Bullet's motion threshold and swept
  /// sphere. Chipmunk has none. DEFAULT: false
  bool continuous = false;
  bool awake = false;  ///< balls never fall asleep. DEFAULT: false, what the engine does by itself
  /// [length/time] pairs that approach more slowly get restitution 0, >= 0. DEFAULT: the engine's own. Chipmunk has none.
  std::optional<double> threshold{};

  friend bool operator==(const GameEngineOptions&, const GameEngineOptions&) = default;
};

/// An engine written as name[:continuous][:awake][:threshold=V]; dt is left at 0. Known engines parse whether built or not.
/// Throws InputError that names the known engines or options, with all that is wrong.
[[nodiscard]] GameEngineOptions parse_game_engine(std::string_view text);

/// The shortest text that parses to the same options, but for dt: "box2d", "box2d:continuous".
[[nodiscard]] std::string game_engine_text(const GameEngineOptions& options);

/// What the engine `name` does not have or only approximates in this scene, a sentence each, with numbers in the user's
/// units. The engine need not be built. Throws InputError for a scene that is wrong and for an unknown name.
[[nodiscard]] std::vector<std::string> cannot_represent(const Scene& scene, std::string_view name);

/// Those of them for which make_game_engine refuses the scene.
[[nodiscard]] std::vector<std::string> refuses(const Scene& scene, std::string_view name);

/// The scene at its start, ready to step. Throws InputError with every problem: of the scene, of the options, of what the
/// engine refuses, and of an engine that is not built (naming the package to install).
[[nodiscard]] std::unique_ptr<Stepper> make_game_engine(const Scene& scene, const GameEngineOptions& options);

}  // namespace carom
