#include "registry.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "carom/scene/growing.hpp"
#include "adapters.hpp"
#include "carom/scene/exact_only.hpp"
#include "limits.hpp"

namespace carom {

namespace {

GameEngine box2d() {
  return {
      "box2d",
      "",
      "libbox2d-dev",
      false,
      true,
      "8 velocity and 3 position iterations; warm starting; continuous detection against what is not dynamic; restitution "
      "0 below 1 m/s; slop 0.005 m; at most 2 m a step; sleep after 0.5 s below 0.01 m/s; no damping, no friction"};
}
GameEngine chipmunk() {
  return {"chipmunk",
          "",
          "libchipmunk-dev",
          false,
          false,
          "10 iterations; slop 0.1; overlap bias 0.9^60 a second; contact persistence 3 steps; no sleeping; no damping, no "
          "friction"};
}
GameEngine bullet() {
  return {"bullet",
          "",
          "libbullet-dev",
          false,
          true,
          "10 iterations of the sequential impulse solver; warm starting 0.85; split impulse; restitution 0 below 0.2 m/s; "
          "contact breaking threshold 0.02 m; sleep after 2 s below 0.8 m/s; no damping, no friction. continuous: motion "
          "threshold of one radius, swept sphere of 0.4 radii"};
}

std::vector<GameEngine> known_engines() {
  std::vector<GameEngine> all{box2d(), chipmunk(), bullet()};
#ifdef CAROM_BOX2D
  all[0].built = true;
  all[0].version = game_engine::box2d_version();
#endif
#ifdef CAROM_CHIPMUNK
  all[1].built = true;
  all[1].version = game_engine::chipmunk_version();
#endif
#ifdef CAROM_BULLET
  all[2].built = true;
  all[2].version = game_engine::bullet_version();
#endif
  return all;
}

std::array<game_engine::EngineFacts, 3> known_facts() {
  using game_engine::EngineFacts;
  std::array all{EngineFacts{"Box2D", 2, 0, true, true}, EngineFacts{"Chipmunk", 2, 5, false, false},
                 EngineFacts{"Bullet", 3, 0, true, true}};
#ifdef CAROM_BOX2D
  all[0].make = game_engine::make_box2d;
#endif
#ifdef CAROM_CHIPMUNK
  all[1].make = game_engine::make_chipmunk;
#endif
#ifdef CAROM_BULLET
  all[2].make = game_engine::make_bullet;
#endif
  return all;
}

}  // namespace

const std::vector<GameEngine>& game_engines() {
  static const std::vector<GameEngine> all = known_engines();
  return all;
}

namespace game_engine {

std::size_t engine_number(std::string_view name) {
  std::vector<std::string> known;
  for (std::size_t k = 0; k < game_engines().size(); ++k) {
    if (game_engines()[k].name == name) return k;
    known.push_back(game_engines()[k].name);
  }
  throw InputError({"", 0, fmt::format("no game engine is called \"{}\"", name),
                    fmt::format("the known ones are {}", fmt::join(known, ", ")), ""});
}

const EngineFacts& engine_facts(std::size_t number) {
  static const std::array<EngineFacts, 3> all = known_facts();
  return all[number];
}

}  // namespace game_engine

std::vector<std::string> refuses(const Scene& scene, std::string_view name) {
  const std::size_t number = game_engine::engine_number(name);
  return game_engine::refusals(game_engine::make_layout(scene, game_engine::engine_facts(number).size), number);
}

std::vector<std::string> cannot_represent(const Scene& scene, std::string_view name) {
  const std::size_t number = game_engine::engine_number(name);
  std::vector<std::string> beyond;
  for (const Problem& p : exact_only(scene)) beyond.push_back(fmt::format("{}: {}", p.what, p.why));
  if (!beyond.empty()) return beyond;
  const game_engine::Layout layout = game_engine::make_layout(scene, game_engine::engine_facts(number).size);
  std::vector<std::string> all = game_engine::refusals(layout, number);
  if (balls_grow(scene)) all.push_back(fmt::format("{} has no balls that grow.", game_engine::engine_facts(number).title));
  if (!all.empty()) return all;
  return game_engine::approximations(layout, number);
}

std::unique_ptr<Stepper> make_game_engine(const Scene& scene, const GameEngineOptions& options) {
  const std::size_t number = game_engine::engine_number(options.engine);
  const GameEngine& engine = game_engines()[number];
  const game_engine::EngineFacts& facts = game_engine::engine_facts(number);
  std::vector<Problem> problems;
  const auto wrong = [&](std::string what, std::string why, std::string hint) {
    problems.push_back({"", 0, std::move(what), std::move(why), std::move(hint)});
  };
  if (!engine.built)
    wrong(fmt::format("{} is not in this carom", facts.title), "it is built in where its development package is found",
          fmt::format("Install {} and build carom again", engine.package));
  if (!(options.dt > 0) || std::isinf(options.dt))
    wrong(fmt::format("a time step of {}", options.dt), "a step is a positive number", "");
  if (options.continuous && !engine.continuous)
    wrong(fmt::format("{} has no continuous collision detection", facts.title), "", "Leave out \"continuous\"");
  if (options.threshold && !facts.thresholds)
    wrong(fmt::format("{} has no threshold of restitution", facts.title), "it gives every impact its restitution",
          "Leave out \"threshold\"");
  if (options.threshold && (!(*options.threshold >= 0) || std::isinf(*options.threshold)))
    wrong(fmt::format("a threshold of {}", *options.threshold), "it is a speed, at least 0", "");
  const std::vector<Problem> beyond = exact_only(scene);
  problems.insert(problems.end(), beyond.begin(), beyond.end());
  if (!beyond.empty()) throw InputError(problems);
  game_engine::Layout layout;
  try {
    layout = game_engine::make_layout(scene, facts.size);
    for (const std::string& sentence : game_engine::refusals(layout, number))
      problems.push_back({scene.file, 0, sentence.substr(0, sentence.size() - 1), "", ""});
  } catch (const InputError& error) {
    problems.insert(problems.end(), error.problems().begin(), error.problems().end());
  }
  if (!problems.empty()) throw InputError(problems);
  return facts.make(std::move(layout), options);
}

}  // namespace carom
