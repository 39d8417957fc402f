#pragma once
// The known engines: what is needed to describe each, built or not, and to make it if it is.

#include <memory>
#include <string>
#include <string_view>

#include "carom/core/error.hpp"
#include "carom/game_engine/game_engine.hpp"
#include "layout.hpp"

namespace carom::game_engine {

struct EngineFacts {
  std::string title;        ///< "Box2D"
  int dimension = 2;        ///< of its space
  int size = 0;             ///< median radius below 2^size of its units of length
  bool floats = false;      ///< computes in single precision
  bool thresholds = false;  ///< knows the option `threshold`
  std::unique_ptr<Stepper> (*make)(Layout, const GameEngineOptions&) = nullptr;  ///< none: not built
};

/// Row of the engine in game_engines(). Throws InputError that names the known ones.
[[nodiscard]] std::size_t engine_number(std::string_view name);
[[nodiscard]] const EngineFacts& engine_facts(std::size_t number);

}  // namespace carom::game_engine
