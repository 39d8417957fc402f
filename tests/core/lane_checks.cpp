#include "core/lane_checks.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "carom/core/clock.hpp"
#include "carom/core/random.hpp"
#include "carom/core/wide_lanes.hpp"
#include "carom/predict/first_meetings.hpp"

namespace carom::testing::CAROM_VARIANT {

namespace {

bool same(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

/// Log-uniform, either sign.
double draw(RandomStream& draws) {
  const double size = std::ldexp(1 + draws.uniform(), static_cast<int>(60 * draws.uniform()) - 30);
  return draws.uniform() < 0.5 ? -size : size;
}
DoubleDouble draw_wide(RandomStream& draws) { return two_sum(draw(draws), 0x1p-55 * draw(draws)); }

void check_wide(RandomStream& draws, LaneDifferences& found) {
  std::array<DoubleDouble, lanes> x, y;
  WideLanes a, b;
  for (std::size_t k = 0; k < lanes; ++k) {
    x[k] = draw_wide(draws);
    y[k] = draw_wide(draws);
    a.hi[k] = x[k].hi;
    a.lo[k] = x[k].lo;
    b.hi[k] = y[k].hi;
    b.lo[k] = y[k].lo;
  }
  const WideLanes sum = a + b, product = a * b, exact = two_prod(a.hi, b.hi), difference = two_diff(a.hi, b.hi);
  const Lanes rounded = rounded_sum(a.hi, b);
  const auto differs = [](const DoubleDouble& s, const DoubleDouble& t) { return !same(s.hi, t.hi) || !same(s.lo, t.lo); };
  for (int k = 0; k < lanes; ++k) {
    const DoubleDouble p = x[static_cast<std::size_t>(k)], q = y[static_cast<std::size_t>(k)];
    found.wide += differs(sum[k], p + q);
    found.wide += differs(product[k], p * q);
    found.wide += differs(exact[k], two_prod(p.hi, q.hi));
    found.wide += differs(difference[k], two_diff(p.hi, q.hi));
    found.wide += !same(rounded[k], narrow(DoubleDouble(p.hi) + q));
  }
  const WideLanes three = sums_in_order<3>(a, b), two = sums_in_order<2>(a, b);
  found.dots += differs(three[0], (x[0] + x[1]) + x[2]) + differs(three[1], (y[0] + y[1]) + y[2]);
  found.dots += differs(two[0], x[0] + x[1]) + differs(two[1], y[0] + y[1]);
}

void check_order(RandomStream& draws, LaneDifferences& found) {
  Lanes x;
  for (int k = 0; k < lanes; ++k) x[k] = std::abs(draw(draws));
  const LaneMask order = in_order(x);
  const Lanes sorted = permuted(x, order);
  long long seen = 0;
  for (int k = 0; k < lanes; ++k) {
    seen |= 1LL << order[k];
    found.order += !same(sorted[k], x[order[k]]);
    found.order += k > 0 && sorted[k] < sorted[k - 1] * (1 - 0x1p-50);
  }
  found.order += seen != 15;
}

void check_clock(RandomStream& draws, LaneDifferences& found) {
  const Time<double> t{static_cast<std::int64_t>(1e6 * draws.uniform()), draws.uniform()};
  Lanes flight;
  for (int k = 0; k < lanes; ++k) flight[k] = std::abs(draw(draws));
  flight[0] = static_cast<double>(static_cast<std::int64_t>(flight[0]));
  flight[1] = 1 - t.offset;
  if (draws.uniform() < 0.2) flight[3] = FirstMeetings::no_flight;
  LaneMask epoch;
  Lanes offset;
  after(t, flight, epoch, offset);
  for (int k = 0; k < lanes; ++k) {
    const Time<double> then = after(t, double{flight[k]});
    found.clock += then.epoch != epoch[k] || !same(then.offset, offset[k]);
  }
}

void check_integers(RandomStream& draws, LaneDifferences& found) {
  std::uint32_t from[8], to[16] = {};
  for (std::uint32_t& n : from) n = static_cast<std::uint32_t>(0x1p32 * draws.uniform());
  const unsigned bits = static_cast<unsigned>(256 * draws.uniform());
  write_chosen(to, from, bits);
  std::size_t n = 0;
  for (std::size_t k = 0; k < 8; ++k)
    if ((bits >> k & 1) != 0) found.chosen += to[n++] != from[k];

  Ints8 a = {}, b = {};
  std::array<std::int32_t, 8> truth{};
  for (int k = 0; k < 8; ++k) {
    const auto coordinate = [&draws] { return static_cast<std::int32_t>(2048 * draws.uniform()) - 1024; };
    const std::int32_t ax = coordinate(), ay = coordinate(), bx = coordinate(), by = coordinate();
    a[k] = (ax & 0xffff) | static_cast<std::int32_t>(static_cast<std::uint32_t>(ay) << 16);
    b[k] = (bx & 0xffff) | static_cast<std::int32_t>(static_cast<std::uint32_t>(by) << 16);
    truth[static_cast<std::size_t>(k)] = (ax - bx) * (ax - bx) + (ay - by) * (ay - by);
  }
  const Ints8 squares = sums_of_squares(differences16(a, b));
  for (int k = 0; k < 8; ++k) found.squares += squares[k] != truth[static_cast<std::size_t>(k)];
}

}  // namespace

LaneDifferences lane_differences() {
  LaneDifferences found;
  RandomStream draws(20260, 1);
  for (; found.looked_at < 20000; ++found.looked_at) {
    check_wide(draws, found);
    check_order(draws, found);
    check_clock(draws, found);
    check_integers(draws, found);
  }
  return found;
}

}  // namespace carom::testing::CAROM_VARIANT
