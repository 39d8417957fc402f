// The heap against the list, over random changes.

#include "carom/queue/heap_queue.hpp"

#include <gtest/gtest.h>

#include "carom/queue/event_queue.hpp"
#include "queue/list_queue.hpp"
#include "sim/scenes.hpp"

namespace carom {
namespace {

using testing::Dice;
using testing::ListQueue;

static_assert(EventQueue<HeapQueue<double, 2>> && EventQueue<ListQueue<double, 2>>);

bool same(const Event<double, 2>& a, const Event<double, 2>& b) { return !precedes(a, b) && !precedes(b, a); }

// Times, kinds, balls and partners from small sets: ties of every order.
Event<double, 2> random_event(Dice& dice) {
  Event<double, 2> e;
  const auto pick = [&](int n) { return static_cast<int>(dice.unit() * n); };
  if (pick(10) == 0) return e;
  e.time = {pick(3), pick(4) / 4.0};
  e.kind = static_cast<EventKind>(pick(5));
  e.ball = static_cast<std::uint32_t>(pick(3));
  e.partner = static_cast<std::uint32_t>(pick(3));
  e.feature = pick(2);
  e.image[0] = pick(3) - 1;
  return e;
}

TEST(HeapQueue, keeps_the_first_event_on_top_through_any_changes) {
  Dice dice(1);
  for (const std::uint32_t slots : {1u, 2u, 7u, 60u}) {
    HeapQueue<double, 2> heap;
    ListQueue<double, 2> list;
    for (int life = 0; life < 2; ++life) {  // reset starts afresh
      heap.reset(slots);
      list.reset(slots);
      EXPECT_EQ(heap.top().kind, EventKind::none);
      for (int i = 0; i < 3000; ++i) {
        const auto slot = static_cast<std::uint32_t>(dice.unit() * slots);
        const Event<double, 2> event = random_event(dice);
        heap.assign(slot, event);
        list.assign(slot, event);
        ASSERT_TRUE(same(heap.top(), list.top())) << slots << " slots, change " << i;
        ASSERT_LT(heap.top_slot(), slots);
      }
    }
  }
}

TEST(EventOrder, is_total_and_as_documented) {
  Event<double, 2> a, b;
  a.time = b.time = {1, 0.5};
  a.kind = b.kind = EventKind::ball_ball;
  EXPECT_FALSE(precedes(a, b));
  b.image[1] = 1;
  EXPECT_TRUE(precedes(a, b));
  a.feature = 1;
  EXPECT_TRUE(precedes(b, a)) << "feature before image";
  b.partner = 1;
  EXPECT_TRUE(precedes(a, b)) << "partner before feature";
  a.ball = 1;
  EXPECT_TRUE(precedes(b, a)) << "ball before partner";
  a.kind = EventKind::ball_wall;
  EXPECT_TRUE(precedes(a, b)) << "walls before balls";
  a.kind = EventKind::bookkeeping;
  EXPECT_TRUE(precedes(b, a)) << "balls before bookkeeping";
  b.kind = EventKind::motion_change;
  a.kind = EventKind::scheduled;
  EXPECT_TRUE(precedes(a, b)) << "what is scheduled comes first";
  a.time.offset = 0.75;
  EXPECT_TRUE(precedes(b, a)) << "time before all else";
  a.time = {0, 0.9};
  EXPECT_TRUE(precedes(a, b)) << "epochs before offsets";
  EXPECT_TRUE(precedes(b, Event<double, 2>{})) << "none is last";
}

}  // namespace
}  // namespace carom
