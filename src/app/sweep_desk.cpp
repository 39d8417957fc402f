#include "sweep_desk.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <thread>
#include <utility>

#include "sweep_row.hpp"

namespace carom::app {

namespace {

constexpr std::int64_t largest_block = 256;
constexpr std::int64_t furthest_ahead = std::int64_t{1} << 20;  // rows that may wait for a slow run

/// So many runs that they take some tens of milliseconds.
std::int64_t wanted_after(const Block& block, double seconds) {
  if (seconds < 0.02) return std::min(2 * block.size(), largest_block);
  return seconds > 0.1 ? std::max<std::int64_t>(block.size() / 2, 1) : block.size();
}

void work_alone(const SweepPlan& plan, Desk& desk, const std::atomic<bool>& interrupt) {
  using Clock = std::chrono::steady_clock;
  Rows done;
  std::int64_t wanted = 1;
  while (const std::optional<Block> block = desk.next(std::exchange(done, {}), wanted)) {
    const Clock::time_point begin = Clock::now();
    done.begin = block->begin;
    for (std::int64_t run = block->begin; run < block->end && !interrupt; ++run) {
      std::optional<std::string> row = sweep_row(plan, run, interrupt);
      if (!row) break;
      done.lines.push_back(std::move(*row));
    }
    wanted = wanted_after(*block, std::chrono::duration<double>(Clock::now() - begin).count());
  }
}

}  // namespace

SweepDesk::SweepDesk(std::int64_t first, std::int64_t end, std::function<void(const std::string&)> row,
                     const std::atomic<bool>& interrupt)
    : next_(first), end_(end), delivered_(first), row_(std::move(row)), interrupt_(interrupt) {}

std::optional<Block> SweepDesk::next(Rows done, std::int64_t wanted) {
  const std::lock_guard lock(mutex_);
  if (!done.lines.empty()) early_.emplace(done.begin, std::move(done.lines));
  while (!early_.empty() && early_.begin()->first == delivered_) {
    for (const std::string& line : early_.begin()->second) row_(line);
    delivered_ += static_cast<std::int64_t>(early_.begin()->second.size());
    early_.erase(early_.begin());
  }
  // The run that is waited for is somebody's already: who comes too early gets one run at a time, and none beyond that.
  const std::int64_t room = std::max<std::int64_t>(delivered_ + furthest_ahead - next_, 1);
  if (interrupt_ || next_ >= end_) return std::nullopt;
  const Block block{next_, std::min({next_ + wanted, next_ + room, end_})};
  next_ = block.end;
  return block;
}

std::int64_t SweepDesk::delivered() const {
  const std::lock_guard lock(mutex_);
  return delivered_;
}

void work(const SweepPlan& plan, Desk& desk, int threads, std::atomic<bool>& interrupt) {
  // Boost keeps the digits of new numbers for the whole process, and changes them within operations on numbers of several.
  if (plan.precision().kind == Precision::Kind::decimal) threads = 1;
  std::mutex mutex;
  std::exception_ptr failure;
  const auto guarded = [&] {
    try {
      work_alone(plan, desk, interrupt);
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
      interrupt = true;
    }
  };
  std::vector<std::thread> others;
  for (int k = 1; k < threads; ++k) others.emplace_back(guarded);
  guarded();
  for (std::thread& t : others) t.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace carom::app
