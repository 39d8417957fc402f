#include "ensemble_keys.hpp"

#include <charconv>

namespace carom::scene_text {

std::optional<BallKey> ball_key(std::string_view key) {
  constexpr std::string_view ball = "ball.";
  if (!key.starts_with(ball)) return std::nullopt;
  key.remove_prefix(ball.size());
  BallKey found;
  const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), found.ball);
  if (error != std::errc()) return std::nullopt;
  const std::string_view rest = key.substr(static_cast<std::size_t>(end - key.data()));
  if (rest == ".position") found.what = BallKey::What::position;
  else if (rest == ".velocity") found.what = BallKey::What::velocity;
  else if (!rest.empty()) return std::nullopt;
  return found;
}

bool is_seed_key(std::string_view key) { return key.ends_with(".seed"); }

}  // namespace carom::scene_text
