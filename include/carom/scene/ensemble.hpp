#pragma once
// The runs of an ensemble: what each sets over the scene, as a function of its number.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "carom/scene/read.hpp"
#include "carom/scene/scene.hpp"

namespace carom {

/// The text of a scene file, and what is set over it for every run.
struct SceneSource {
  std::string text;
  std::string file;  ///< for messages
  std::vector<Override> set{};
};

/// KEY=[a, b, c] lists values, KEY=FROM:TO:STEPS takes equal steps, KEY=FROM:TO draws from a range, KEY=random draws what
/// the key suggests. Throws InputError.
[[nodiscard]] VarySpec parse_vary(std::string_view text);

/// Run i has combination i mod C of the listed values, C combinations in the order of their keys, the last key fastest; so
/// more runs at each add to the end. What is drawn for it depends on (seed, i, key) alone: uniform in a range; without one,
/// at ball.N.velocity a direction at the speed of the scene, at ball.N.position a place in the space, or within the walls
/// of an open one, at ball.N both, at a seed a seed. + - * / and sqrt alone, but for places within arcs.
class Ensemble {
 public:
  /// `spec` is that of a scene that `validate` finds no fault with. Throws InputError if there is nothing to vary.
  Ensemble(SceneSource source, EnsembleSpec spec);

  [[nodiscard]] std::int64_t runs() const noexcept { return combinations_ * spec_.count.value_or(1); }
  [[nodiscard]] std::int64_t combinations() const noexcept { return combinations_; }
  [[nodiscard]] const EnsembleSpec& spec() const noexcept { return spec_; }

  /// The values that the runs of a combination share.
  [[nodiscard]] std::vector<Override> listed(std::int64_t combination) const;

  struct Member {
    Scene scene;
    std::vector<Override> set;  ///< over the source: makes the same run by itself, from the same text
  };
  /// Throws InputError. `attempt` > 0 draws places anew, where the start of the one before was refused.
  [[nodiscard]] Member member(std::int64_t run, std::int64_t attempt = 0) const;

  /// Whether places are drawn.
  [[nodiscard]] bool places() const;

 private:
  SceneSource source_;
  EnsembleSpec spec_;
  std::int64_t combinations_ = 1;
};

/// What [ensemble] asks for, in sentences; none: the scene has no [ensemble].
[[nodiscard]] std::vector<std::string> ensemble_explained(const Scene& scene);

/// So many runs at most: run numbers are exact in a double.
inline constexpr std::int64_t most_runs = std::int64_t{1} << 40;

}  // namespace carom
