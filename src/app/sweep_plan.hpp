#pragma once
// What a sweep is to do: known before its first run, and the same to everybody who takes part.

#include <cstdint>
#include <string>

#include "carom/core/precision.hpp"
#include "carom/scene/ensemble.hpp"
#include "sweep_options.hpp"
#include "write/json_text.hpp"

namespace carom::app {

class SweepPlan {
 public:
  /// Reads the scene and makes that of the first run, for what is wrong with it to be said at once. Throws InputError.
  explicit SweepPlan(const SweepOptions& options);

  [[nodiscard]] const Ensemble& ensemble() const noexcept { return ensemble_; }
  [[nodiscard]] const Precision& precision() const noexcept { return precision_; }
  [[nodiscard]] bool wants_final() const noexcept { return final_; }
  [[nodiscard]] const std::string& title() const noexcept { return title_; }
  [[nodiscard]] bool names_files() const noexcept { return names_files_; }  ///< under [output]: a sweep writes none

  /// All that its rows depend on, but for how many there are.
  [[nodiscard]] Json print() const;

 private:
  SceneSource source_;
  Ensemble ensemble_;
  Precision precision_;
  bool final_;
  bool names_files_ = false;
  std::string title_;
};

}  // namespace carom::app
