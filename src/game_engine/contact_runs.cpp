#include "contact_runs.hpp"

#include <algorithm>

namespace carom::game_engine {

void ContactRuns::touch(const ContactKey& key, double overlap, double impulse) {
  Run& run = runs_[key];
  if (run.found < 0) {
    run.found = static_cast<std::int64_t>(found_.size());
    found_.push_back({key});
  }
  Found& found = found_[static_cast<std::size_t>(run.found)];
  found.overlap = std::max(found.overlap, overlap);
  if (impulse > 0 && !run.counted) found.counts = run.counted = true;
  if (found.counts) found.impulse += impulse;
}

void ContactRuns::finish_step(const Layout& layout, double time, std::int64_t step, const StepSink& sink) {
  for (const Found& f : found_) {
    if (!sink) break;
    StepContact contact;
    contact.time = time;
    contact.step = step;
    contact.kind = f.key.kind;
    contact.ball = f.key.ball;
    contact.partner = f.key.partner;
    contact.feature = f.key.feature;
    contact.overlap = layout.to_user_length(f.overlap);
    contact.impulse = layout.to_user_momentum(f.impulse);
    sink(contact);
  }
  found_.clear();
  if (end_ == RunEnd::silence) std::erase_if(runs_, [](const auto& run) { return run.second.found < 0; });
  for (auto& [key, run] : runs_) run.found = -1;
}

ContactKey contact_key(const Party& a, const Party& b, const Point& x, const Point& drift) {
  if (a.piece != nullptr) return contact_key(b, a, x, drift);
  if (b.piece == nullptr) return {EventKind::ball_ball, std::min(a.ball, b.ball), std::max(a.ball, b.ball), 0};
  return {EventKind::ball_wall, a.ball, b.piece->wall, nearest_feature(*b.piece, x, drift)};
}

}  // namespace carom::game_engine
