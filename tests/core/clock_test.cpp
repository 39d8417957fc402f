// The clock: a grid, exact differences, one rounding, and an end that is `never`.

#include "carom/core/clock.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "sim/properties.hpp"

namespace carom {
namespace {

using T = Time<double>;
__extension__ using Ticks = __int128;
constexpr double tick = 0x1p-53;

bool on_grid(const T& t) { return t.offset >= 0 && t.offset < 1 && std::nearbyint(t.offset / tick) == t.offset / tick; }

/// A moment on the grid, often near the ends of an epoch.
T any_moment() {
  const auto epoch = *rc::gen::oneOf(rc::gen::inRange<std::int64_t>(-3, 4),
                                     rc::gen::inRange<std::int64_t>(-last_epoch / 2, last_epoch / 2));
  const std::int64_t whole = std::int64_t{1} << 53;
  const auto ticks = *rc::gen::oneOf(rc::gen::inRange<std::int64_t>(0, whole), rc::gen::inRange<std::int64_t>(0, 5),
                                     rc::gen::inRange<std::int64_t>(whole - 5, whole));
  return {epoch, double(ticks) * tick};
}

/// A flight of any size: 2^-120 to 2^60, its significand full, or a small count of half ticks.
double any_flight() {
  if (*rc::gen::inRange(0, 4) == 0) return *rc::gen::inRange(0, 9) * tick / 2;
  const auto bits = *rc::gen::inRange<std::int64_t>(std::int64_t{1} << 52, std::int64_t{1} << 53);
  return std::ldexp(double(bits), *rc::gen::inRange(-172, 8));
}

TEST(Clock, orders_moments) {
  const std::vector<T> rising{{-2, 0.9}, {-1, 0.0}, {-1, 0.5}, {0, 0.0}, {0, tick}, {0, 1 - tick}, {1, 0.0}, T::never()};
  for (std::size_t i = 0; i < rising.size(); ++i)
    for (std::size_t j = 0; j < rising.size(); ++j) {
      EXPECT_EQ(rising[i] < rising[j], i < j);
      EXPECT_EQ(rising[i] <= rising[j], i <= j);
      EXPECT_EQ(rising[i] == rising[j], i == j);
      EXPECT_EQ(rising[i] > rising[j], i > j);
    }
}

TEST(Clock, carries_into_the_next_epoch) {
  EXPECT_EQ(after(T{0, 0.75}, 0.25), (T{1, 0.0}));
  EXPECT_EQ(after(T{0, 0.75}, 0.5), (T{1, 0.25}));
  EXPECT_EQ(after(T{0, 1 - tick}, tick), (T{1, 0.0}));
  EXPECT_EQ(after(T{0, 1 - tick}, tick * 0.75), (T{1, 0.0})) << "rounded up";
  EXPECT_EQ(after(T{0, 1 - tick}, tick * 0.25), (T{0, 1 - tick})) << "rounded down";
  EXPECT_EQ(after(T{-1, 0.5}, 0.5), (T{0, 0.0}));
  EXPECT_EQ(after(T{-1, 0.5}, 2.75), (T{2, 0.25}));
  EXPECT_EQ(after(T{7, 0.5}, 0x1p52), (T{7 + (std::int64_t{1} << 52), 0.5}));
}

TEST(Clock, ends_at_never) {
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(after(T{0, 0.5}, inf).is_never());
  EXPECT_TRUE(after(T{0, 0.5}, std::nan("")).is_never());
  EXPECT_TRUE(after(T{0, 0.5}, 0x1p63).is_never());
  EXPECT_TRUE(after(T{last_epoch, 0.5}, 1.0).is_never());
  EXPECT_TRUE(after(T{last_epoch - 10, 0.0}, 0x1p61).is_never());
  EXPECT_FALSE(after(T{-last_epoch, 0.0}, 0x1p61).is_never());
  EXPECT_FALSE(after(T{0, 0.0}, 0x1p61).is_never());
}

// |after(t, s) - (t + s)| <= half a tick and the rounding of s beside it; nothing is lost to the size of the epoch.
TEST(Clock, after_is_on_the_grid_and_rounds_by_at_most_a_tick) {
  carom::testing::expect_property(
      [] {
        const T t = any_moment();
        const double s = any_flight();
        const T later = after(t, s);
        RC_PRE(!later.is_never());
        RC_ASSERT(on_grid(later));
        RC_ASSERT(later >= t);
        using Wider = long double;  // 64 bits: enough for the offset, with whole epochs taken out
        const Wider whole = std::floor(Wider(s)), exact = Wider(t.offset) + (Wider(s) - whole);
        const Wider got = Wider(later.epoch - t.epoch - std::int64_t(whole)) + Wider(later.offset);
        RC_ASSERT(std::abs(got - exact) <= Wider(tick) * 0.75L);
      },
      20000, 1);
}

TEST(Clock, after_is_monotone) {
  carom::testing::expect_property(
      [] {
        const T t = any_moment();
        const double s = any_flight(), longer = *rc::gen::element(0, 1) ? std::nextafter(s, HUGE_VAL) : s + any_flight();
        RC_ASSERT(after(t, s) <= after(t, longer));
      },
      20000, 2);
}

// Flights that are whole ticks are added exactly, so `elapsed` takes them back bit for bit.
TEST(Clock, elapsed_is_exact_within_2_to_the_53_ticks) {
  carom::testing::expect_property(
      [] {
        const T t = any_moment();
        const double s = double(*rc::gen::inRange<std::int64_t>(0, std::int64_t{1} << 53)) * tick;
        const T later = after(t, s);
        RC_PRE(!later.is_never());
        RC_ASSERT(elapsed(t, later) == s);
        RC_ASSERT(elapsed(later, t) == -s);
      },
      20000, 3);
}

TEST(Clock, elapsed_is_rounded_once_and_changes_sign_with_its_ends) {
  carom::testing::expect_property(
      [] {
        const T a = any_moment();
        T b = any_moment();
        b.epoch = a.epoch + *rc::gen::inRange<std::int64_t>(-100000, 100000);
        const Ticks ticks = (Ticks(b.epoch - a.epoch) << 53) + Ticks(b.offset / tick) - Ticks(a.offset / tick);
        RC_ASSERT(elapsed(a, b) == std::ldexp(double(ticks), -53));  // the conversion rounds once, to nearest
        RC_ASSERT(elapsed(b, a) == -elapsed(a, b));
      },
      20000, 4);
}

// The promise of the whole: shifting every moment by whole epochs changes no flight and no offset.
TEST(Clock, does_not_see_a_shift_by_whole_epochs) {
  carom::testing::expect_property(
      [] {
        const T t = any_moment(), u = any_moment();
        const double s = any_flight();
        const auto shift = *rc::gen::inRange<std::int64_t>(-last_epoch / 4, last_epoch / 4);
        const auto moved = [&](T m) { return m.is_never() ? m : T{m.epoch + shift, m.offset}; };
        const T plain = after(t, s), shifted = after(moved(t), s);
        RC_PRE(!plain.is_never() && !shifted.is_never());
        RC_ASSERT(moved(plain) == shifted);
        RC_PRE(std::abs(double(t.epoch) - double(u.epoch)) < 0x1p53);
        RC_ASSERT(elapsed(t, u) == elapsed(moved(t), moved(u)));
      },
      20000, 5);
}

}  // namespace
}  // namespace carom
