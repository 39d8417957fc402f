#pragma once
// The keys that `random` has a meaning for.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace carom::scene_text {

/// ball.N, ball.N.position or ball.N.velocity.
struct BallKey {
  enum class What : std::uint8_t { both, position, velocity };
  std::size_t ball = 0;
  What what = What::both;
};

[[nodiscard]] std::optional<BallKey> ball_key(std::string_view key);

/// run.seed, gas.N.seed, lattice.N.seed.
[[nodiscard]] bool is_seed_key(std::string_view key);

}  // namespace carom::scene_text
