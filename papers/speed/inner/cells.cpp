// The cells that find a ball's neighbours: laying them out, and going through those around a ball.

#include <benchmark/benchmark.h>

#include "carom/search/cell_grid.hpp"
#include "gas.hpp"

namespace carom::speed {
namespace {

/// Items are balls.
void cells_laid_out(benchmark::State& state) {
  const WorldType world = spheres(state.range(0));
  const Flight flight;
  CellGrid<double, 3> grid;
  for (auto _ : state) grid.reset(world, flight, world.start);
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(cells_laid_out)->Arg(1000)->Arg(100000);

/// Items are partners.
void partners_of_a_ball(benchmark::State& state) {
  const WorldType world = spheres(state.range(0));
  const Flight flight;
  CellGrid<double, 3> grid;
  grid.reset(world, flight, world.start);
  const auto n = static_cast<std::uint32_t>(world.balls.size());
  std::uint32_t i = 0;
  std::int64_t partners = 0;
  for (auto _ : state) {
    std::uint64_t sum = 0;
    grid.for_each_partner(world, i, [&](std::uint32_t j, const Image<3>&) {
      sum += j;
      ++partners;
    });
    benchmark::DoNotOptimize(sum);
    i = static_cast<std::uint32_t>((i + std::uint64_t{2654435761u}) % n);
  }
  state.SetItemsProcessed(partners);
}
BENCHMARK(partners_of_a_ball)->Arg(1000)->Arg(100000);

}  // namespace
}  // namespace carom::speed
