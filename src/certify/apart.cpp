#include "apart.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace carom::certify {

namespace {

constexpr int coarse_depth = 12;      // what doubles do not show by then, they hardly show
constexpr int most_halvings = 2000;
constexpr double most_images = 1e6;  // of a pair, in one span
constexpr double most_turns = 1e9;   // periods between two balls
constexpr double turn_doubt = 1e-6;  // above what the rounding of a quotient moves it below most_turns

template <class I>
constexpr bool is_fine = std::is_same_v<I, Enclosure>;

/// The end of an interval as a point.
template <class I>
I end_of(const Enclosure& x, bool upper) {
  if constexpr (is_fine<I>) {
    return upper ? x.upper() : x.lower();
  } else {
    return Outward(upper ? x.outward().upper : x.outward().lower);
  }
}

}  // namespace

Apart::Apart(const System& system, int bits)
    : system_(system), fine_(system, numbers_of(system)), coarse_(system, coarse(fine_.numbers())), depth_(std::min(bits, most_halvings)) {
  if (system.dimension == 1) order_on_a_line();
}

/// Balls on a line are met by their neighbours alone: nobody passes a third.
void Apart::order_on_a_line() {
  const std::size_t n = system_.balls.size();
  right_of_.resize(n);
  left_of_.resize(n);
  std::vector<boost::multiprecision::cpp_int> turns(n);
  std::vector<Rational> place(n);
  for (std::size_t i = 0; i < n; ++i) {
    place[i] = system_.balls[i].position[0];
    if (!system_.period) continue;
    const Rational q = place[i] / (*system_.period)[0];
    turns[i] = numerator(q) / denominator(q);
    if (Rational(turns[i]) > q) --turns[i];
    place[i] -= Rational(turns[i]) * (*system_.period)[0];
  }
  std::vector<std::uint32_t> order(n);
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return place[a] < place[b]; });
  for (std::size_t k = 0; k < n; ++k) {
    const bool last = k + 1 == n;
    if (last && (!system_.period || n < 2)) break;
    const std::uint32_t i = order[k], j = order[last ? 0 : k + 1];
    const boost::multiprecision::cpp_int between = turns[i] - turns[j];
    if (abs(between) > std::int64_t(most_turns)) throw std::invalid_argument("balls start too many periods from each other");
    const auto period = static_cast<std::int64_t>(between) + (last ? 1 : 0);
    right_of_[i] = Neighbour{j, period};
    left_of_[j] = Neighbour{i, -period};
  }
}

/// The Bernstein coefficients of the gap over the span, without the zeros of the contacts that are known:
/// (t - t0)^m h at the beginning, (t1 - t) h at the end, h > 0 [papers/certify/README.md, eq. 6].
template <class I>
std::vector<I> Apart::over(const Span& span, const Enclosure& base, Polynomial<I> gap, std::span<const KnownContact> known) const {
  for (const KnownContact& c : known) {
    I root;
    convert(c.time - base, root);
    for (int m = 0; m < c.order; ++m) gap = without_root(gap, root);
    if (c.at_end) gap = negated(std::move(gap));
  }
  return bernstein(gap, end_of<I>(span.from - base, false), end_of<I>(span.to - base, true));
}

template <class I>
Proof Apart::pair_at(const Gaps<I>& gaps, std::uint32_t i, const Flight& a, std::uint32_t j, const Flight& b, const Period& period,
                     const Span& span, std::span<const KnownContact> known) const {
  const Enclosure& base = later(a.reference, b.reference);
  const Relative<I> r = gaps.between(i, gaps.state(i, a, base), j, gaps.state(j, b, base), period);
  std::vector<KnownContact> here;
  for (const KnownContact& c : known)
    if (c.period == period) here.push_back(c);
  return positive(over(span, base, gaps.pair_gap(i, j, r), here), is_fine<I> ? depth_ : coarse_depth);
}

/// Calls f for each image of ball j that may come within reach of ball i in the span, until it does not prove.
template <class F>
Proof Apart::for_each_image(std::uint32_t i, const Flight& a, std::uint32_t j, const Flight& b, const Span& span, F&& f) const {
  const Enclosure& base = later(a.reference, b.reference);
  const Relative<Outward> r = coarse_.between(i, coarse_.state(i, a, base), j, coarse_.state(j, b, base), {});
  const Outward s(end_of<Outward>(span.from - base, false).lower, end_of<Outward>(span.to - base, true).upper);
  const Outward reach = coarse_.reach_of_pair(i, j);
  std::array<double, 3> first{}, last{};
  double images = 1;
  for (std::size_t k = 0; k < static_cast<std::size_t>(system_.dimension); ++k) {
    Outward y = r.y[k] + r.u[k] * s;
    if (r.curved) y = y + half(r.a[k] * square(s));
    // -reach <= y + n L <= reach
    const double edge = coarse_.numbers().period[k].lower;
    first[k] = std::ceil(below(-reach.upper - y.upper) / edge - turn_doubt);
    last[k] = std::floor(above(reach.upper - y.lower) / edge + turn_doubt);
    if (!(std::abs(first[k]) < most_turns && std::abs(last[k]) < most_turns)) return Proof::unknown;
    images *= std::max(0.0, last[k] - first[k] + 1);
  }
  if (!(images <= most_images)) return Proof::unknown;
  for (double x = first[0]; x <= last[0]; ++x)
    for (double y = first[1]; y <= last[1]; ++y)
      for (double z = first[2]; z <= last[2]; ++z) {
        const Proof proof = f(Period{std::int64_t(x), std::int64_t(y), std::int64_t(z)});
        if (proof != Proof::yes) return proof;
      }
  return Proof::yes;
}

Proof Apart::pair(std::uint32_t i, const Flight& a, std::uint32_t j, const Flight& b, const Span& span,
                  std::span<const KnownContact> known) const {
  if (system_.balls[i].fixed && system_.balls[j].fixed) return Proof::yes;
  const auto image = [&](const Period& period) {
    if (pair_at(coarse_, i, a, j, b, period, span, known) == Proof::yes) return Proof::yes;
    return pair_at(fine_, i, a, j, b, period, span, known);
  };
  if (system_.dimension == 1) {
    for (const Neighbour* n : {right_of_[i] ? &*right_of_[i] : nullptr})
      if (n != nullptr && n->ball == j) return image({n->period, 0, 0});
    return Proof::yes;
  }
  if (system_.balls[i].radius == 0 && system_.balls[j].radius == 0) return Proof::yes;  // two points never meet
  if (!system_.period) return image({});
  return for_each_image(i, a, j, b, span, image);
}

template <class I>
Proof Apart::piece_at(const Gaps<I>& gaps, std::uint32_t i, const Flight& a, std::size_t piece, const Span& span,
                      std::span<const KnownContact> known) const {
  const int depth = is_fine<I> ? depth_ : coarse_depth;
  const Relative<I> r = gaps.beside(i, state_of<I>(a), piece, a.reference);
  if (system_.pieces[piece].kind != PieceKind::edge) return positive(over(span, a.reference, gaps.piece_gap(i, piece, r), known), depth);
  // On one side of the line, on the other, before the beginning, or beyond the end.
  std::vector<std::vector<I>> ways;
  for (const int side : {1, -1}) {
    std::vector<KnownContact> here;
    for (const KnownContact& c : known)
      if (c.side == side) here.push_back(c);
    ways.push_back(over(span, a.reference, gaps.height(i, piece, r, side), here));
  }
  ways.push_back(over(span, a.reference, gaps.before(piece, r), {}));
  ways.push_back(over(span, a.reference, gaps.beyond(piece, r), {}));
  return one_positive(std::move(ways), depth);
}

Proof Apart::piece(std::uint32_t i, const Flight& a, std::size_t piece, const Span& span, std::span<const KnownContact> known) const {
  // A point meets no vertex unless it meets an edge there.
  if (system_.pieces[piece].kind == PieceKind::vertex && system_.balls[i].radius == 0) return Proof::yes;
  if (piece_at(coarse_, i, a, piece, span, known) == Proof::yes) return Proof::yes;
  return piece_at(fine_, i, a, piece, span, known);
}

}  // namespace carom::certify
