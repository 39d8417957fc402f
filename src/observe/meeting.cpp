#include "carom/observe/meeting.hpp"

#include <algorithm>
#include <array>
#include <unordered_map>

namespace carom {

namespace {

/// The exact meetings of one pair, and how many of each list have been seen.
struct Pair {
  std::vector<std::size_t> exact;                              // places in the list, in order
  std::int64_t due = 0, expected = 0, came = 0, answered = 0;  // exact, here; up to the end, and with the allowance
};

class Matcher {
 public:
  Matcher(const Meetings& exact, const MatchWindow& window, const std::vector<bool>& obstacle)
      : exact_(exact), window_(window), obstacle_(obstacle) {
    for (std::size_t i = 0; i < exact.size(); ++i) {
      if (exact[i].time > window.end + window.early) continue;
      Pair& pair = pair_of(exact[i]);
      pair.exact.push_back(i);
      ++pair.expected;
      if (exact[i].time <= window.end) ++pair.due;
    }
  }

  void add(const Meeting& m) {
    if (m.time > window_.end + window_.late) return;
    Pair& pair = pair_of(m);
    const auto k = static_cast<std::size_t>(pair.answered++);
    if (m.time > window_.end) return;
    ++pair.came;
    if (k >= pair.exact.size()) return;
    note_order(m.ball, pair.exact[k]);
    if (m.kind == EventKind::ball_ball) note_order(m.partner, pair.exact[k]);
  }

  Tally tally() const {
    Tally t;
    t.swapped = swapped_;
    for (const auto& pairs : pairs_)
      for (const auto& [key, p] : pairs) {
        t.missed += std::max<std::int64_t>(0, p.due - p.answered);
        if (p.due > 0 && p.answered == 0) ++t.missed_pairs;
        t.spurious += std::max<std::int64_t>(0, p.came - p.expected);
      }
    return t;
  }

 private:
  Pair& pair_of(const Meeting& m) {
    return pairs_[m.kind == EventKind::ball_ball ? 0 : 1][(std::uint64_t{m.ball} << 32) | m.partner];
  }

  void note_order(std::uint32_t ball, std::size_t place) {
    if (ball < obstacle_.size() && obstacle_[ball]) return;
    const auto [previous, first] = last_.try_emplace(ball, place);
    if (!first && exact_[place].time < exact_[previous->second].time) ++swapped_;
    previous->second = place;
  }

  const Meetings& exact_;
  const MatchWindow& window_;
  const std::vector<bool>& obstacle_;
  std::array<std::unordered_map<std::uint64_t, Pair>, 2> pairs_;  // of two balls; of a ball and a wall
  std::unordered_map<std::uint32_t, std::size_t> last_;           // by ball: the place its last meeting answers to
  std::int64_t swapped_ = 0;
};

}  // namespace

Tally match(const Meetings& exact, const Meetings& here, const MatchWindow& window, const std::vector<bool>& obstacle) {
  Matcher matcher(exact, window, obstacle);
  for (const Meeting& m : here) matcher.add(m);
  return matcher.tally();
}

}  // namespace carom
