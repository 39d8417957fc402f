#pragma once
// What [observe] asks for and a scene has no meaning for: all of it at once.

#include <string>
#include <vector>

#include "carom/core/error.hpp"
#include "carom/scene/scene.hpp"

namespace carom {

class ObserveJudgement {
 public:
  explicit ObserveJudgement(const Scene& scene) : scene_(scene) {}

  void refuse(const std::string& key, std::string why, std::string hint) {
    add("observe." + key + " has no meaning in this scene", std::move(why), std::move(hint));
  }
  void add(std::string what, std::string why, std::string hint) {
    problems_.push_back({scene_.file, scene_.observe.where.line, std::move(what), std::move(why), std::move(hint)});
  }
  void throw_if_any() {
    if (!problems_.empty()) throw InputError(std::move(problems_));
  }

 private:
  const Scene& scene_;
  std::vector<Problem> problems_;
};

}  // namespace carom
