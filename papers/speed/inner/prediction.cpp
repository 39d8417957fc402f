// One pair prediction, and the search for the first meeting of a ball with all in its cell and those around it.

#include <benchmark/benchmark.h>

#include <vector>

#include "carom/predict/ball_ball.hpp"
#include "carom/search/cell_grid.hpp"
#include "gas.hpp"

namespace carom::speed {
namespace {

struct Pair {
  std::uint32_t i, j;
  Image<3> image;
};

/// Pairs in cells next to each other, ball by ball: the memory is met as a run meets it, not in order.
void next_meeting_of_pairs(benchmark::State& state) {
  const WorldType world = spheres(state.range(0));
  const Flight flight;
  CellGrid<double, 3> grid;
  grid.reset(world, flight, world.start);
  std::vector<Pair> pairs;
  const auto n = static_cast<std::uint32_t>(world.balls.size());
  for (std::uint32_t k = 0; k < 1000; ++k) {
    const std::uint32_t i = static_cast<std::uint32_t>(k * std::uint64_t{2654435761u} % n);
    grid.for_each_partner(world, i, [&](std::uint32_t j, const Image<3>& image) { pairs.push_back({i, j, image}); });
  }
  std::size_t next = 0;
  for (auto _ : state) {
    const Pair& p = pairs[next];
    if (++next == pairs.size()) next = 0;
    benchmark::DoNotOptimize(next_meeting(flight, world, p.i, p.j, p.image));
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(next_meeting_of_pairs)->Arg(1000)->Arg(100000);

/// All that is done for one party of a collision but the queue: items are pairs.
void first_meeting_of_a_ball(benchmark::State& state) {
  const WorldType world = spheres(state.range(0));
  const Flight flight;
  CellGrid<double, 3> grid;
  grid.reset(world, flight, world.start);
  const auto n = static_cast<std::uint32_t>(world.balls.size());
  std::uint32_t i = 0;
  std::int64_t pairs = 0;
  for (auto _ : state) {
    Event<double, 3> first;
    grid.for_each_partner(world, i, [&](std::uint32_t j, const Image<3>& image) {
      consider_meeting(flight, world, i, j, image, first);
      ++pairs;
    });
    benchmark::DoNotOptimize(first);
    i = static_cast<std::uint32_t>((i + std::uint64_t{2654435761u}) % n);
  }
  state.SetItemsProcessed(pairs);
}
BENCHMARK(first_meeting_of_a_ball)->Arg(1000)->Arg(100000);

}  // namespace
}  // namespace carom::speed
