#include "view_scene.hpp"

#include "model.hpp"
#include "write/replay_scene.hpp"

namespace carom::app {

namespace {

std::string text_with_settings(const RunRecord& record) {
  std::string text;
  for (const std::string& set : record.set) text += "# --set " + set + '\n';
  return text + (text.empty() ? "" : "\n") + record.text;
}

}  // namespace

Json scene_of_page(const Scene& scene, const Simulation& simulation, const ReplayLog& log, const RunRecord& record) {
  Json j = replay_scene(scene, simulation);
  j["energy"] = log.initial_energy();
  j["version"] = CAROM_VERSION;
  j["text"] = text_with_settings(record);
  j["model"] = collision_rules(scene);
  for (const std::string& sentence : not_modelled(scene)) j["model"].push_back("Not modelled: " + sentence);
  return j;
}

}  // namespace carom::app
