#pragma once
// Where the runs of a sweep are handed out and their rows come back: any number of workers, rows in the order of runs.

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "sweep_plan.hpp"

namespace carom::app {

/// Runs from `begin` up to, without, `end`.
struct Block {
  std::int64_t begin = 0, end = 0;
  [[nodiscard]] std::int64_t size() const noexcept { return end - begin; }
};

/// Rows of consecutive runs from `begin` on.
struct Rows {
  std::int64_t begin = 0;
  std::vector<std::string> lines;
};

/// The side of it that a worker sees.
class Desk {
 public:
  virtual ~Desk() = default;
  /// Takes rows that are done (none: at the beginning) and hands out up to `wanted` runs; none: there are no more.
  virtual std::optional<Block> next(Rows done, std::int64_t wanted) = 0;
};

class SweepDesk final : public Desk {
 public:
  /// `row` is called with each row from run `first` on, in the order of runs, by one thread at a time.
  SweepDesk(std::int64_t first, std::int64_t end, std::function<void(const std::string&)> row, const std::atomic<bool>& interrupt);

  std::optional<Block> next(Rows done, std::int64_t wanted) override;

  [[nodiscard]] std::int64_t delivered() const;  ///< rows so far, with those before `first`

 private:
  mutable std::mutex mutex_;
  std::int64_t next_, end_, delivered_;
  std::map<std::int64_t, std::vector<std::string>> early_;  // rows that wait for others before them, by their first run
  std::function<void(const std::string&)> row_;
  const std::atomic<bool>& interrupt_;
};

/// Takes runs from the desk until there are no more, on `threads` threads. An exception in one ends all and is thrown here.
void work(const SweepPlan& plan, Desk& desk, int threads, std::atomic<bool>& interrupt);

}  // namespace carom::app
