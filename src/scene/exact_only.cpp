#include "carom/scene/exact_only.hpp"

namespace carom {

std::vector<Problem> exact_only(const Scene& scene) {
  std::vector<Problem> problems;
  const auto refuse = [&](const Where& where, const char* what) {
    problems.push_back({scene.file, where.line, what, "fixed steps and game engines do not know it", "Use the event-driven mode"});
  };
  if (is_magnetic(scene)) refuse(scene.motion.where, "motion.magnetic");
  for (const WallSpec& w : scene.walls)
    if (w.oscillation) refuse(w.where, "wall.oscillation");
  return problems;
}

}  // namespace carom
