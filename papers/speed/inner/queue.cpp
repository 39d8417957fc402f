// The event queue under the load of a run: the first event is taken, its ball and one other get new ones.

#include <benchmark/benchmark.h>

#include "carom/core/random.hpp"
#include "carom/queue/heap_queue.hpp"

namespace carom::speed {
namespace {

using Queue = HeapQueue<double, 3>;

/// An event after `now` by an exponential time of mean 2^-10 of an epoch.
Event<double, 3> event_after(const Time<double>& now, std::uint32_t ball, RandomStream& draw) {
  Event<double, 3> e;
  const double wait = -natural_log(1 - draw.uniform()) * 0x1p-10;
  e.time = after(now, wait);
  e.ball = ball;
  e.kind = EventKind::ball_ball;
  return e;
}

/// Items are collisions: two events replaced.
void heap_of_a_run(benchmark::State& state) {
  const auto n = static_cast<std::uint32_t>(state.range(0));
  RandomStream draw(1, 0, 0);
  Queue queue;
  queue.reset(n);
  Time<double> now{};
  for (std::uint32_t i = 0; i < n; ++i) queue.assign(i, event_after(now, i, draw));
  for (auto _ : state) {
    now = queue.top().time;
    const std::uint32_t i = queue.top_slot();
    const auto j = static_cast<std::uint32_t>(draw.uniform() * n);
    queue.assign(i, event_after(now, i, draw));
    queue.assign(j, event_after(now, j, draw));
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(heap_of_a_run)->RangeMultiplier(10)->Range(1000, 1000000);

}  // namespace
}  // namespace carom::speed
