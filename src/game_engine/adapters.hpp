#pragma once
// The adapters, of which only those whose engine was found are compiled, and the scales that their settings are made for.

#include <memory>
#include <string>

#include "carom/game_engine/game_engine.hpp"
#include "layout.hpp"

namespace carom::game_engine {

[[nodiscard]] std::unique_ptr<Stepper> make_box2d(Layout layout, const GameEngineOptions& options);
[[nodiscard]] std::unique_ptr<Stepper> make_chipmunk(Layout layout, const GameEngineOptions& options);
[[nodiscard]] std::unique_ptr<Stepper> make_bullet(Layout layout, const GameEngineOptions& options);

[[nodiscard]] std::string box2d_version();
[[nodiscard]] std::string chipmunk_version();
[[nodiscard]] std::string bullet_version();

/// How far inside a circle the straight edges that stand for it may lie, in the engine's unit of length: Box2D's own slop.
inline constexpr double box2d_ring_depth = 0.005;
inline constexpr double chipmunk_ring_depth = 0.1;  ///< Chipmunk's own slop
inline constexpr double bullet_ring_depth = 0.005;

/// Triangles of the 3-D mesh that stands for a sphere from inside: an icosahedron, refined so many times.
inline constexpr int bullet_ring_levels = 5;

}  // namespace carom::game_engine
