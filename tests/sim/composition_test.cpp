// Whatever queue and search a simulation is made of, its log is the same, bit for bit.

#include <gtest/gtest.h>

#include "carom/motion/free_flight.hpp"
#include "carom/queue/heap_queue.hpp"
#include "carom/search/all_pairs.hpp"
#include "carom/sim/event_driven.hpp"
#include "carom/world/build.hpp"
#include "queue/list_queue.hpp"
#include "search/repeating_pairs.hpp"
#include "sim/scenes.hpp"

namespace carom {
namespace {

using namespace testing;

/// One collision as bits: two logs are the same if these are equal.
using Bits = std::vector<std::uint64_t>;

template <int D>
struct BitLog {
  static constexpr bool wants_records = true;
  std::vector<Bits>* log;

  void operator()(const Record<double, D>& r) const {
    Bits bits{std::uint64_t(r.time.epoch), std::bit_cast<std::uint64_t>(r.time.offset), std::uint64_t(r.kind),
              std::uint64_t(r.feature), std::uint64_t(r.tie)};
    const auto add = [&](double x) { bits.push_back(std::bit_cast<std::uint64_t>(x)); };
    for (const auto* p : {&r.ball, &r.partner}) {
      bits.push_back(p->number);
      for (int k = 0; k < D; ++k) {
        add(p->position[k]);
        add(p->velocity_before[k]);
        add(p->velocity_after[k]);
      }
    }
    for (const double x : {r.impulse, r.gap, r.dissipated, r.injected}) add(x);
    log->push_back(std::move(bits));
  }
};

template <int D, class Search, class Queue>
std::vector<Bits> log_of(const Scene& scene, std::int64_t events) {
  World<double, D> world = build<double, D>(scene);
  EventDriven<FreeFlight<double, D>, Search, Queue> engine(world, FreeFlight<double, D>{});
  std::vector<Bits> log;
  engine.advance(Time<double>::never(), events, BitLog<D>{&log});
  EXPECT_EQ(engine.exactness().clamped, 0);
  return log;
}

template <int D>
void expect_same_log(const char* what, const Scene& scene, std::int64_t events) {
  using Heap = HeapQueue<double, D>;
  using List = ListQueue<double, D>;
  const auto log = log_of<D, AllPairs<double, D>, Heap>(scene, events);
  EXPECT_GE(log.size(), 10u) << what;
  EXPECT_EQ(log, (log_of<D, AllPairs<double, D>, List>(scene, events))) << what << ": another queue";
  EXPECT_EQ(log, (log_of<D, RepeatingPairs<double, D>, Heap>(scene, events))) << what << ": another search";
  EXPECT_EQ(log, (log_of<D, RepeatingPairs<double, D>, List>(scene, events))) << what << ": another queue and search";
}

Scene with_restitution(Scene scene, double e) {
  scene.collision.restitution = e;
  return scene;
}

/// Equal balls on a square lattice with speeds of +-1 along the axes: nearly every event is a tie.
Scene all_ties() {
  Scene scene = box({0.0, 0.0}, {16.0, 16.0});
  Dice dice(77);
  for (int i = 0; i < 16; ++i) {
    const bool across = dice.unit() < 0.5;
    const double v = dice.unit() < 0.5 ? 1.0 : -1.0;
    scene.balls.push_back(ball({2.0 + 4 * (i % 4), 2.0 + 4 * (i / 4)}, {across ? v : 0.0, across ? 0.0 : v}, 1.0));
  }
  return scene;
}

TEST(Composition, the_log_does_not_depend_on_the_queue_or_the_search) {
  const std::int64_t n = scaled_count(5000);
  expect_same_log<2>("gas of equal disks", mixed_box(2, 25, 20.0, 1, 1.0, 1.0), n);
  expect_same_log<2>("disks of many sizes and masses", mixed_box(2, 20, 20.0, 2, 0.1, 100.0), n);
  expect_same_log<3>("spheres", mixed_box(3, 27, 12.0, 3), n);
  expect_same_log<1>("rods", rods(12, 4), n);
  expect_same_log<2>("granular disks", with_restitution(mixed_box(2, 16, 12.0, 5), 0.9), n / 5);
  expect_same_log<3>("granular spheres", with_restitution(mixed_box(3, 16, 12.0, 6), 0.8), n / 10);
  expect_same_log<2>("a touching rack", rack_and_cue(), n);
  expect_same_log<2>("a touching rack, hit aside", rack_and_cue(0.2), n);
  expect_same_log<2>("a touching granular rack", with_restitution(rack_and_cue(0.1), 0.95), n / 10);
  expect_same_log<2>("nothing but ties", all_ties(), n);
}

// A billiard of one ball has a queue of one slot.
TEST(Composition, one_ball_alone) { expect_same_log<2>("one disk", mixed_box(2, 1, 5.0, 8), 200); }

}  // namespace
}  // namespace carom
