// The list of near pairs hides nothing and costs nothing that grows.

#include <atomic>
#include <cstdlib>
#include <new>

#include <gtest/gtest.h>

#include "sim/fixed_step/stepping.hpp"

namespace {
std::atomic<std::int64_t> allocations{0};
}  // namespace

// Not inlined: where it is, g++ takes malloc and free for a pair that does not match.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size > 0 ? size : 1)) return p;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace carom {
namespace {

using namespace testing;

void expect_the_same(const Scene& scene, double dt, const std::string& method, std::int64_t steps) {
  Scene every_pair = scene;
  every_pair.engine.search = SearchKind::all_pairs;
  const Stepped a = run_steps(scene, dt, method, steps), b = run_steps(every_pair, dt, method, steps);
  ASSERT_EQ(a.contacts.size(), b.contacts.size()) << method << ", dt = " << dt;
  ASSERT_GT(a.collisions(), 20) << method << ", dt = " << dt;
  for (std::size_t k = 0; k < a.contacts.size(); ++k) {
    const StepContact &p = a.contacts[k], &q = b.contacts[k];
    ASSERT_TRUE(p.step == q.step && p.kind == q.kind && p.ball == q.ball && p.partner == q.partner &&
                p.feature == q.feature && same_bits(p.time, q.time) && same_bits(p.overlap, q.overlap) &&
                same_bits(p.impulse, q.impulse))
        << method << ", contact " << k;
  }
  for (std::size_t i = 0; i < a.balls.size(); ++i)
    for (std::size_t k = 0; k < a.balls[i].position.size(); ++k)
      ASSERT_TRUE(same_bits(a.balls[i].unwrapped_position[k], b.balls[i].unwrapped_position[k]))
          << method << ", ball " << i;
}

// Bit for bit, whether a step is a small part of a ball or several of them.
TEST(NearList, cells_give_what_all_pairs_give) {
  for (const std::string& method : every_method)
    for (const double dt : {0.01, 0.06, 1.5}) {
      expect_the_same(mixed_box(2, 64, 16.0, 41, 0.2), dt, method, dt < 1 ? 150 : 30);
      Scene periodic = mixed_box(2, 49, 14.0, 42, 0.4);
      periodic.space.kind = SpaceKind::periodic;
      expect_the_same(periodic, dt, method, dt < 1 ? 150 : 30);
    }
  for (const char* method : {"discrete", "swept", "swept:substeps", "speculative"}) {
    expect_the_same(mixed_box(3, 64, 8.0, 43), 0.05, method, 100);
    expect_the_same(rods(30, 44), 0.05, method, 200);
    Scene small = mixed_box(2, 2, 2.2, 45);  // a ball meets several images of the other
    small.space.kind = SpaceKind::periodic;
    expect_the_same(small, 0.05, method, 1000);
  }
}

TEST(NearList, a_step_allocates_nothing_once_all_has_grown) {
  for (const std::string& method : every_method) {
    const auto s = stepper(mixed_box(2, 100, 20.0, 46), 0.02, method);
    std::int64_t contacts = 0;
    const StepSink sink = [&](const StepContact&) { ++contacts; };
    for (int n = 0; n < 2000; ++n) s->step(sink);
    const std::int64_t before = allocations, seen = contacts;
    for (int n = 0; n < 500; ++n) s->step(sink);
    // A vector that has room for the most of 2000 steps may still have to grow once or twice for that of 500 more.
    EXPECT_LE(allocations - before, 8) << method;
    EXPECT_GT(contacts, seen + 100) << method;
  }
}

}  // namespace
}  // namespace carom
