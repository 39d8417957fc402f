#include "replay.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace carom::certify {

namespace {

// A log's own rounding errors are of the size of the widths here, since both are carried in as many digits. A time that is
// off by more than so many widths is wrong.
constexpr double log_slack = 1024.0;
constexpr std::size_t most_recent = 256;
constexpr std::int64_t most_periods = std::int64_t{1} << 52;  // a double holds them exactly

Apart::Period back(Apart::Period period) {
  for (std::int64_t& n : period) n = -n;
  return period;
}

}  // namespace

Replay::Replay(const System& system, int digits)
    : system_(system), digits_(digits), apart_(system, bits_of_digits(digits)), impacts_(system, apart_.gaps()) {
  const Enclosure start = Enclosure::of(system.start);
  last_time_ = start;
  latest_start_ = start.lower();
  forgotten_ = Enclosure(-std::numeric_limits<double>::infinity());
  for (const SystemBall& b : system.balls) {
    Flight f;
    // The state is given at the start itself, which need not be a point in binary: its enclosure's middle is the reference,
    // and the state is taken there.
    f.reference = start.middle();
    f.start = start;
    f.earliest = start.lower();
    const Enclosure lag = f.reference - start;
    for (std::size_t k = 0; k < 3; ++k) {
      f.state.v[k] = Enclosure::of(b.velocity[k]);
      f.state.x[k] = Enclosure::of(b.position[k]);
      if (lag.is_zero()) continue;
      const Enclosure gain = b.fixed ? Enclosure() : Enclosure::of(system.acceleration[k]) * lag;
      f.state.x[k] = f.state.x[k] + (f.state.v[k] + half(gain)) * lag;
      f.state.v[k] = f.state.v[k] + gain;
    }
    convert(f.state.x, f.near.x);
    convert(f.state.v, f.near.v);
    flights_.push_back(f);
  }
  before_ = flights_;
}

Finding Replay::report(Proof proof, std::string what, const Enclosure& width) const {
  return {proof, events_ + 1, std::move(what), width.log10_size(), false};
}

std::string Replay::name(const Parties& p) const {
  if (p.piece) return fmt::format("ball {} and wall {}", p.left, system_.walls[system_.pieces[*p.piece].wall]);
  return fmt::format("ball {} and ball {}", std::min(p.left, p.right), std::max(p.left, p.right));
}

/// Who the claim is about; none if there are no such parties, or none that could meet.
std::optional<Replay::Parties> Replay::parties_of(const Claim& c) const {
  Parties p;
  if (c.ball >= flights_.size()) return std::nullopt;
  for (const std::int64_t n : c.period)
    if (n > most_periods || n < -most_periods || (n != 0 && !system_.period)) return std::nullopt;
  p.left = c.ball;
  if (c.kind == MeetingKind::ball_wall) {
    for (std::size_t k = 0; k < system_.pieces.size(); ++k)
      if (system_.pieces[k].wall == c.partner && system_.pieces[k].feature == c.feature) p.piece = k;
    return p.piece && system_.balls[c.ball].mass ? std::optional(p) : std::nullopt;
  }
  if (c.partner >= flights_.size() || c.partner == c.ball) return std::nullopt;
  if (!system_.balls[c.ball].mass && !system_.balls[c.partner].mass) return std::nullopt;
  p.right = c.partner;
  p.period = c.period;
  if (system_.dimension > 1) return p;
  const auto is = [](const std::optional<Apart::Neighbour>& n, std::uint32_t ball, std::int64_t period) {
    return n && n->ball == ball && n->period == period;
  };
  if (is(apart_.right_of(c.ball), c.partner, c.period[0])) return p;
  if (!is(apart_.right_of(c.partner), c.ball, -c.period[0])) return std::nullopt;
  std::swap(p.left, p.right);
  p.period[0] = -p.period[0];
  return p;
}

Finding Replay::take(const Claim& claim) {
  const std::optional<Parties> parties = parties_of(claim);
  if (!parties) return report(Proof::no, "there are no such parties to meet", Enclosure());
  const Parties& p = *parties;
  const Gaps<Enclosure>& gaps = apart_.gaps();
  const Flight& a = flights_[p.left];
  const PieceKind kind = p.piece ? system_.pieces[*p.piece].kind : PieceKind::sphere;
  if (kind == PieceKind::vertex && system_.balls[p.left].radius == 0)
    return report(Proof::unknown, name(p) + ": a point meets a vertex, where a wall has no normal", Enclosure());
  const bool is_edge = kind == PieceKind::edge;

  Enclosure guess = Enclosure::near(claim.lower);
  Enclosure reach = slack_ + slack_ + guess.size() * Enclosure(0x1p-20);
  if (claim.enclosed) {
    const Enclosure last = Enclosure::near(claim.upper);
    reach = reach + (last - guess).size();
    guess = half(guess + last).middle();
  }
  if (!guess.is_bounded()) return report(Proof::no, name(p) + ": its time is no number", Enclosure());
  const auto relative_to_piece = [&](const Enclosure& base) {
    return gaps.beside(p.left, gaps.state(p.left, a, base), *p.piece, base);
  };
  int side = 1;
  if (is_edge) {
    const Enclosure rate = gaps.height(p.left, *p.piece, relative_to_piece(guess), 1)[1];
    if (!is_negative(rate) && !is_positive(rate)) return report(Proof::unknown, name(p) + ": a grazing contact cannot be told from none", rate);
    side = is_negative(rate) ? 1 : -1;
  }
  const auto gap_at = [&](const Enclosure& base) -> Polynomial<Enclosure> {
    if (is_edge) return gaps.height(p.left, *p.piece, relative_to_piece(base), side);
    if (p.piece) return gaps.piece_gap(p.left, *p.piece, relative_to_piece(base));
    const Flight& b = flights_[p.right];
    return gaps.pair_gap(p.left, p.right,
                         gaps.between(p.left, gaps.state(p.left, a, base), p.right, gaps.state(p.right, b, base), p.period));
  };
  const Contact contact = find_contact(gap_at, guess, reach.upper());
  if (contact.proof != Proof::yes) return report(contact.proof, name(p) + ": " + contact.what, contact.offset);
  const Enclosure time = contact.time();
  if (is_edge) {
    // Between its ends.
    const Relative<Enclosure> r = relative_to_piece(contact.base);
    const Enclosure before = value(gaps.before(*p.piece, r), contact.offset), beyond = value(gaps.beyond(*p.piece, r), contact.offset);
    if (is_positive(before) || is_positive(beyond)) return report(Proof::no, name(p) + ": it is past the end of the edge", time.width());
    if (!is_negative(before) || !is_negative(beyond))
      return report(Proof::unknown, name(p) + ": the edge cannot be told from its end", before);
  }
  if (Finding f = judge_order(p, time); f.proof != Proof::yes) return f;
  if (Finding f = judge_time(p, claim, time); f.proof != Proof::yes) return f;
  if (Finding f = prove_apart(p, time, side); f.proof != Proof::yes) return f;
  std::vector<Next> next = impact(p, contact, side);
  if (Finding f = prove_either_order(time, next); f.proof != Proof::yes) return f;
  commit(p, std::move(next), time);
  return {Proof::yes, events_, "", time.width().log10_size(), false};
}

/// After the last events of its balls, and not before the last one of the log.
Finding Replay::judge_order(const Parties& p, const Enclosure& time) const {
  for (const std::uint32_t i : p.balls()) {
    const Flight& f = flights_[i];
    if (is_before(f.start, time)) continue;
    if (is_before(time, f.start)) return report(Proof::no, fmt::format("{}: it is before event {} of ball {}", name(p), f.met.event, i), time.width());
    return report(Proof::unknown, fmt::format("{}: its time cannot be told from that of event {} of ball {}", name(p), f.met.event, i),
                  (time - f.start).size());
  }
  if (is_before(time, latest_start_)) return report(Proof::no, name(p) + ": it is before an event that the log has before it", time.width());
  return {};
}

/// Does the proven time agree with the claimed one?
Finding Replay::judge_time(const Parties& p, const Claim& claim, const Enclosure& time) {
  const std::string who = name(p);
  if (claim.enclosed) {
    const Enclosure claimed = Enclosure::within(claim.lower, claim.upper);
    if (time.is_inside(claimed)) return {};
    const bool apart = !time.meets(claimed);
    return report(apart ? Proof::no : Proof::unknown, who + (apart ? ": its time is outside its enclosure" : ": its time cannot be told from the ends of its enclosure"), time.width());
  }
  const Enclosure claimed = Enclosure::near(claim.lower);
  // The last digits of the claim's own text.
  const Enclosure rounding = claimed.size() * Enclosure::near(fmt::format("1e{}", 2 - digits_));
  const Enclosure widest = later(slack_, (time.width() * Enclosure(log_slack)).upper());
  if (!is_before((widest + rounding).upper(), (time - claimed).size())) {
    slack_ = widest;
    return {};
  }
  const Enclosure off = time - claimed;
  if (is_positive(off) || is_negative(off))
    return report(Proof::no, fmt::format("{}: its time is wrong by 1e{:.1f}", who, off.log10_size()), time.width());
  return {};
}

/// The contact that the flights of two balls began with. The motion of an infinite mass goes on: it begins no flight.
std::optional<KnownContact> Replay::begun_together(std::uint32_t i, const Flight& a, std::uint32_t j, const Flight& b) const {
  const auto met = [](const Flight& f, std::uint32_t other) {
    return f.met.event != 0 && f.met.kind == MeetingKind::ball_ball && f.met.partner == other;
  };
  if (met(a, j) && (!system_.balls[j].mass || (met(b, i) && a.met.event == b.met.event)))
    return KnownContact{a.start, false, a.met.order, a.met.period, 1};
  if (met(b, i) && !system_.balls[i].mass) return KnownContact{b.start, false, b.met.order, back(b.met.period), 1};
  return std::nullopt;
}

Finding Replay::prove_balls(std::uint32_t i, const Flight& a, std::uint32_t j, const Flight& b, const Span& span, const KnownContact* end) const {
  std::vector<KnownContact> known;
  if (const auto began = begun_together(i, a, j, b)) known.push_back(*began);
  if (end != nullptr) known.push_back(*end);
  const Proof proof = apart_.pair(i, a, j, b, span, known);
  if (proof == Proof::yes) return {};
  return report(proof, fmt::format("ball {} and ball {} {} between two events of the log", std::min(i, j), std::max(i, j),
                                   proof == Proof::no ? "overlap" : "cannot be told apart"),
                span.to - span.from);
}

Finding Replay::prove_piece(std::uint32_t i, const Flight& a, std::size_t piece, const Span& span, const KnownContact* end) const {
  std::vector<KnownContact> known;
  if (a.met.event != 0 && a.met.kind == MeetingKind::ball_wall && a.met.piece == piece)
    known.push_back({a.start, false, a.met.order, {}, a.met.side});
  if (end != nullptr) known.push_back(*end);
  const Proof proof = apart_.piece(i, a, piece, span, known);
  if (proof == Proof::yes) return {};
  return report(proof, fmt::format("ball {} and wall {} {} between two events of the log", i, system_.walls[system_.pieces[piece].wall],
                                   proof == Proof::no ? "overlap" : "cannot be told apart"),
                span.to - span.from);
}

/// The parties met nobody since their last events, up to this one.
Finding Replay::prove_apart(const Parties& p, const Enclosure& time, int side) const {
  const KnownContact end{time, true, 1, p.period, side};
  const Enclosure to = time.upper();
  const auto n = static_cast<std::uint32_t>(flights_.size());
  const auto balls = [&](std::uint32_t i, std::uint32_t j) -> Finding {
    const Flight &a = flights_[i], &b = flights_[j];
    const bool meet = !p.piece && i == p.left && j == p.right;
    return prove_balls(i, a, j, b, {later(a.earliest, b.earliest), to}, meet ? &end : nullptr);
  };
  // `done` is a party that has been through already.
  const auto all_of = [&](std::uint32_t i, std::optional<std::uint32_t> done) -> Finding {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    if (system_.dimension > 1) {
      for (std::uint32_t j = 0; j < n; ++j)
        if (j != i && j != done) pairs.push_back(!p.piece && j == p.left ? std::pair{j, i} : std::pair{i, j});  // left, right
    } else {
      if (const auto& right = apart_.right_of(i)) pairs.emplace_back(i, right->ball);
      if (const auto& left = apart_.left_of(i); left && left->ball != done) pairs.emplace_back(left->ball, i);
    }
    for (const auto& [a, b] : pairs) {
      Finding f = balls(a, b);
      if (f.proof == Proof::yes) continue;
      return tie_or(f, p, {a, b, p.period, {}});
    }
    for (std::size_t k = 0; k < system_.pieces.size(); ++k) {
      Finding f = prove_piece(i, flights_[i], k, {flights_[i].earliest, to}, p.piece == k ? &end : nullptr);
      if (f.proof == Proof::yes) continue;
      return tie_or(f, p, {i, 0, {}, k});
    }
    return {};
  };
  // The motion of an infinite mass does not change: with whom it meets is proven for that one.
  std::optional<std::uint32_t> done;
  for (const std::uint32_t i : p.balls()) {
    if (!system_.balls[i].mass) continue;
    if (Finding f = all_of(i, done); f.proof != Proof::yes) return f;
    done = i;
  }
  return {};
}

/// Events that share no ball, and whose times cannot be told apart, may be in either order: a ball's new flight is apart
/// from the other's old one, too.
Finding Replay::prove_either_order(const Enclosure& time, const std::vector<Next>& next) const {
  if (!is_before(forgotten_, time)) return report(Proof::unknown, "too many events at one moment", time.width());
  for (const Recent& r : recent_) {
    if (is_before(r.time, time)) continue;
    for (const std::uint32_t i : r.parties.balls()) {
      if (!system_.balls[i].mass) continue;
      if (flights_[i].met.event != r.event) return report(Proof::unknown, "too many events at one moment", time.width());
      for (const Next& other : next) {
        const Span span{other.flight.earliest, r.latest};
        const bool on_the_left = system_.dimension == 1 && apart_.right_of(other.ball) && apart_.right_of(other.ball)->ball == i;
        Finding f = on_the_left ? prove_balls(other.ball, other.flight, i, before_[i], span, nullptr)
                                : prove_balls(i, before_[i], other.ball, other.flight, span, nullptr);
        if (f.proof == Proof::yes) continue;
        f.proof = Proof::unknown;
        return f;
      }
    }
  }
  return {};
}

std::vector<Replay::Next> Replay::impact(const Parties& p, const Contact& contact, int side) const {
  const Gaps<Enclosure>& gaps = apart_.gaps();
  const auto flight = [&](std::uint32_t ball, const State<Enclosure>& state) {
    Next next{ball, {}};
    Flight& f = next.flight;
    f.reference = contact.base;
    f.state = state;
    convert(state.x, f.near.x);
    convert(state.v, f.near.v);
    f.start = contact.time();
    f.earliest = f.start.lower();
    f.met.event = events_ + 1;
    return next;
  };
  State<Enclosure> a = gaps.state(p.left, flights_[p.left], contact.base);
  if (p.piece) {
    impacts_.wall(p.left, a, *p.piece, side, contact);
    Next next = flight(p.left, a);
    Met& met = next.flight.met;
    met.kind = MeetingKind::ball_wall;
    met.piece = *p.piece;
    met.side = side;
    met.order = impacts_.plastic_wall(p.left, *p.piece) ? 2 : 1;
    return {next};
  }
  State<Enclosure> b = gaps.state(p.right, flights_[p.right], contact.base);
  impacts_.pair(p.left, a, p.right, b, p.period, contact);
  Next left = flight(p.left, a), right = flight(p.right, b);
  left.flight.met.partner = p.right;
  left.flight.met.period = p.period;
  right.flight.met.partner = p.left;
  right.flight.met.period = back(p.period);
  left.flight.met.order = right.flight.met.order = impacts_.plastic_pair(p.left, p.right) ? 2 : 1;
  std::vector<Next> both;
  for (Next* n : {&left, &right})
    if (system_.balls[n->ball].mass) both.push_back(std::move(*n));
  return both;
}

void Replay::commit(const Parties& p, std::vector<Next> next, const Enclosure& time) {
  ++events_;
  for (Next& n : next) {
    before_[n.ball] = std::move(flights_[n.ball]);
    flights_[n.ball] = std::move(n.flight);
  }
  last_time_ = time;
  latest_start_ = later(latest_start_, time.lower());
  recent_.push_back({events_, time, time.upper(), p});
  if (recent_.size() <= most_recent) return;
  forgotten_ = later(forgotten_, recent_.front().latest);
  recent_.pop_front();
}

/// What could not be told, because two meetings happen at one moment, exactly; or as it was. Seen only while everybody is on
/// the first flight.
Finding Replay::tie_or(Finding f, const Parties& p, const FirstMeeting& other) const {
  const auto on_first = [&](std::uint32_t j) { return flights_[j].met.event == 0; };
  const std::vector<std::uint32_t> balls = p.balls();
  if (f.proof != Proof::unknown || !std::all_of(balls.begin(), balls.end(), on_first) || !on_first(other.ball)) return f;
  if (!other.piece && !on_first(other.partner)) return f;
  if (!same_time(exact_gap(system_, {p.left, p.right, p.period, p.piece}), exact_gap(system_, other))) return f;
  f.tie = true;
  f.what = fmt::format("{} meet at the moment at which {} do", name(p), name({other.ball, other.partner, {}, other.piece}));
  return f;
}

Finding Replay::finish(const std::optional<Rational>& until) {
  end_ = until ? Enclosure::of(*until) : last_time_;
  if (is_before(end_, latest_start_)) return report(Proof::no, "the last event is after the end", (latest_start_ - end_).size());
  const Enclosure to = later(end_.upper(), recent_.empty() ? end_.upper() : last_time_.upper());
  const auto n = static_cast<std::uint32_t>(flights_.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    const Flight& a = flights_[i];
    const auto balls = [&](std::uint32_t j) { return prove_balls(i, a, j, flights_[j], {later(a.earliest, flights_[j].earliest), to}, nullptr); };
    if (system_.dimension == 1) {
      if (const auto& right = apart_.right_of(i))
        if (Finding f = balls(right->ball); f.proof != Proof::yes) return f;
    } else {
      for (std::uint32_t j = i + 1; j < n; ++j)
        if (Finding f = balls(j); f.proof != Proof::yes) return f;
    }
    if (system_.balls[i].fixed) continue;
    for (std::size_t k = 0; k < system_.pieces.size(); ++k)
      if (Finding f = prove_piece(i, a, k, {a.earliest, to}, nullptr); f.proof != Proof::yes) return f;
  }
  return {Proof::yes, events_, "", last_time_.width().log10_size(), false};
}

State<Enclosure> Replay::state_at(std::uint32_t ball, const Enclosure& time) const {
  return apart_.gaps().state(ball, flights_[ball], time);
}

double Replay::log10_widest() const {
  double widest = -std::numeric_limits<double>::infinity();
  const auto d = static_cast<std::size_t>(system_.dimension);
  for (const bool speed : {false, true}) {
    Enclosure width, size;
    for (const Flight& f : flights_)
      for (std::size_t k = 0; k < d; ++k) {
        const Enclosure& c = speed ? f.state.v[k] : f.state.x[k];
        width = later(width, c.width());
        size = later(size, c.size());
      }
    if (!size.is_zero()) widest = std::max(widest, width.log10_size() - size.log10_size());
  }
  return widest;
}

}  // namespace carom::certify
