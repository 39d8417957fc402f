#include "checkpoints.hpp"

#include <filesystem>

#include "carom/write/checkpoint_file.hpp"
#include "carom/write/output_file.hpp"

namespace carom::app {

Checkpoints::Checkpoints(const Scene& scene, const std::string& file, const std::string& folder,
                         const Simulation& simulation)
    : path_(file) {
  const OutputSpec& output = scene.output;
  if (path_.empty() && !output.checkpoint.empty())
    path_ = folder.empty() ? output.checkpoint : (std::filesystem::path(folder) / output.checkpoint).string();
  if (output.checkpoint_every_time) every_time_ = *output.checkpoint_every_time;
  if (output.checkpoint_every_events) every_events_ = *output.checkpoint_every_events;
  next_time_ = simulation.time() + every_time_;
  next_events_ = simulation.counts().collisions() + every_events_;
}

void Checkpoints::look(const Simulation& simulation) {
  if (path_.empty()) return;
  const bool due = (every_time_ > 0 && simulation.time() >= next_time_) ||
                   (every_events_ > 0 && simulation.counts().collisions() >= next_events_);
  if (!due) return;
  write(simulation);
  while (every_time_ > 0 && next_time_ <= simulation.time()) next_time_ += every_time_;
  while (every_events_ > 0 && next_events_ <= simulation.counts().collisions()) next_events_ += every_events_;
}

std::string Checkpoints::finish(const Simulation& simulation) {
  if (!path_.empty()) write(simulation);
  return failure_;
}

void Checkpoints::write(const Simulation& simulation) {
  try {
    write_checkpoint(path_, simulation);
    failure_.clear();
  } catch (const OutputError& error) {
    failure_ = error.what();
  }
}

}  // namespace carom::app
