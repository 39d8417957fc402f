#include "sweep_ranks.hpp"

#include <charconv>
#include <chrono>
#include <exception>
#include <sstream>
#include <thread>
#include <utility>

namespace carom::app {

namespace {

// Letters. To rank 0: "BEGIN WANTED STOP\n" and the rows that are done, a line each; or "bye". From rank 0: "begin" or "no";
// then "BEGIN END" for a block, or "none".
const std::string begin = "begin", no = "no", none = "none", bye = "bye";

/// The desk of rank 0, seen from another.
class FarDesk final : public Desk {
 public:
  FarDesk(const Ranks& ranks, const std::atomic<bool>& interrupt) : ranks_(ranks), interrupt_(interrupt) {}

  std::optional<Block> next(Rows done, std::int64_t wanted) override {
    std::string letter = std::to_string(done.begin) + ' ' + std::to_string(wanted) + ' ' + (interrupt_ ? "1" : "0") + '\n';
    for (const std::string& line : done.lines) letter += line + '\n';
    const std::lock_guard lock(mutex_);
    ranks_.send(0, letter);
    std::istringstream answer(ranks_.wait().text);
    Block block;
    if (!(answer >> block.begin >> block.end)) return std::nullopt;
    return block;
  }

 private:
  const Ranks& ranks_;
  const std::atomic<bool>& interrupt_;
  std::mutex mutex_;
};

std::string answered(const std::string& letter, SweepDesk& desk, std::atomic<bool>& interrupt) {
  std::istringstream in(letter);
  Rows done;
  std::int64_t wanted = 1;
  int stop = 0;
  in >> done.begin >> wanted >> stop;
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) done.lines.push_back(line);
  if (stop != 0) interrupt = true;
  const std::optional<Block> block = desk.next(std::move(done), wanted);
  return block ? std::to_string(block->begin) + ' ' + std::to_string(block->end) : none;
}

void tell_all(const Ranks& ranks, const std::string& text) {
  for (int r = 1; r < ranks.size(); ++r) ranks.send(r, text);
}

}  // namespace

void lead(const SweepPlan& plan, SweepDesk& desk, int threads, std::atomic<bool>& interrupt, const Ranks& ranks) {
  tell_all(ranks, begin);
  std::exception_ptr failure, failure_here;
  std::thread here([&] {
    try {
      work(plan, desk, threads, interrupt);
    } catch (...) {
      failure_here = std::current_exception();
    }
  });
  for (int gone = 0; gone < ranks.size() - 1;) {
    const Letter letter = ranks.wait();
    if (letter.text == bye) {
      ++gone;
      continue;
    }
    std::string answer = none;
    try {
      answer = answered(letter.text, desk, interrupt);
    } catch (...) {  // a row that cannot be written: all stop, and it is thrown below
      if (!failure) failure = std::current_exception();
      interrupt = true;
    }
    ranks.send(letter.from, answer);
  }
  here.join();
  if (failure_here) std::rethrow_exception(failure_here);
  if (failure) std::rethrow_exception(failure);
}

void dismiss(const Ranks& ranks) { tell_all(ranks, no); }

void follow(const SweepOptions& options, int threads, std::atomic<bool>& interrupt, const Ranks& ranks) {
  if (ranks.wait().text != begin) return;
  const SweepPlan plan(options);
  FarDesk desk(ranks, interrupt);
  work(plan, desk, threads, interrupt);
  ranks.send(0, bye);
}

}  // namespace carom::app
