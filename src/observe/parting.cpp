#include "carom/observe/parting.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "carom/sim/simulation.hpp"

namespace carom {

namespace {

/// A run, a moment at a time.
class Moments {
 public:
  explicit Moments(const Scene& scene) : scene_(scene), simulation_(scene) {}

  struct Change {
    std::array<double, 3> before, after;
  };
  struct Moment {
    HorizonMark mark;                         // its last collision
    std::map<std::uint32_t, Change> changes;  // of the balls that took part
    double fastest = 0;                       // speed component seen so far
  };

  /// Empty at the end of the run.
  [[nodiscard]] std::optional<Moment> next(const std::atomic<bool>* interrupt) {
    if (!ahead_ && !read(interrupt)) return std::nullopt;
    Moment moment;
    std::int64_t epoch = ahead_->epoch;
    double offset = ahead_->offset;
    const double length = simulation_.epoch_length();
    while (ahead_ && static_cast<double>(ahead_->epoch - epoch) + (ahead_->offset - offset) / length <= one_moment) {
      epoch = ahead_->epoch;
      offset = ahead_->offset;
      take(moment, ahead_->ball);
      if (ahead_->kind == EventKind::ball_ball) take(moment, ahead_->partner);
      moment.mark = {event_, ahead_->time};
      read(interrupt);
    }
    moment.fastest = fastest_;
    return moment;
  }

 private:
  void take(Moment& moment, const Collision::Party& party) {
    const auto [entry, is_new] = moment.changes.try_emplace(party.number, Change{party.velocity_before, {}});
    entry->second.after = party.velocity_after;
    for (std::size_t k = 0; k < 3; ++k)
      fastest_ = std::max({fastest_, std::abs(party.velocity_before[k]), std::abs(party.velocity_after[k])});
  }

  /// Collisions come singly, or several at once where a rule resolves them together.
  bool read(const std::atomic<bool>* interrupt) {
    ahead_.reset();
    if (waiting_.empty()) {
      const bool over = scene_.run.events && simulation_.counts().collisions() >= *scene_.run.events;
      if (over) return false;
      simulation_.advance(scene_.run.until, 1, [this](const Collision& c) { waiting_.push_back(c); }, interrupt);
      if (waiting_.empty()) return false;
    }
    ahead_ = waiting_.front();
    waiting_.erase(waiting_.begin());
    ahead_->digits = nullptr;
    ++event_;
    return true;
  }

  const Scene& scene_;
  Simulation simulation_;
  std::vector<Collision> waiting_;
  std::optional<Collision> ahead_;
  std::int64_t event_ = 0;
  double fastest_ = 0;
};

/// Every ball of a has the same velocity after it in b; one that took part in a alone, the one that it had before.
bool agree(const Moments::Moment& a, const Moments::Moment& b, double size) {
  for (const auto& [ball, change] : a.changes) {
    const auto found = b.changes.find(ball);
    const std::array<double, 3>& other = found != b.changes.end() ? found->second.after : change.before;
    for (std::size_t k = 0; k < 3; ++k)
      if (!(std::abs(change.after[k] - other[k]) <= size)) return false;
  }
  return true;
}

}  // namespace

std::optional<HorizonMark> first_parting(const Scene& scene, const Scene& other, const std::atomic<bool>* interrupt) {
  Moments one(scene), two(other);
  HorizonMark last;
  while (interrupt == nullptr || !interrupt->load()) {
    const auto a = one.next(interrupt), b = two.next(interrupt);
    if (!a && !b) return std::nullopt;
    if (!a || !b) return a ? a->mark : last;
    const double size = parting_share * std::max(a->fastest, b->fastest);
    if (!agree(*a, *b, size) || !agree(*b, *a, size)) return a->mark;
    last = a->mark;
  }
  return std::nullopt;
}

}  // namespace carom
