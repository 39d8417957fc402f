#include "carom/scene/validate.hpp"

#include "rules.hpp"

namespace carom {

std::vector<Problem> validate(const Scene& scene) {
  std::vector<Problem> problems;
  for (scene_text::Finding& f : scene_text::findings(scene)) {
    problems.push_back({scene.file, f.where.line, std::move(f.what), std::move(f.why), std::move(f.hint)});
  }
  return problems;
}

}  // namespace carom
