#include "outcome.hpp"

namespace carom::certify {

namespace {

constexpr int spare_digits = 3;

/// Certain decimal digits of x: -log10 of the width over the size.
double certain_digits(const Enclosure& x, int digits) {
  const double width = x.width().log10_size(), size = x.size().log10_size();
  return std::isinf(width) || std::isinf(size) ? digits : std::max(0.0, size - width);
}

}  // namespace

Bounds bounds_of(const Enclosure& x, int digits) {
  const int shown = std::min(digits, static_cast<int>(certain_digits(x, digits))) + spare_digits;
  return {x.lower_text(shown), x.upper_text(shown)};
}

void judge(Report& report, const Finding& failure, bool interrupted) {
  if (interrupted) {
    report.verdict = Verdict::interrupted;
  } else if (failure.proof != Proof::yes) {
    report.verdict = failure.proof == Proof::no ? Verdict::refuted : Verdict::undecided;
    report.at_event = failure.event;
    report.what = failure.what;
    report.log10_width = failure.log10_width;
    report.tie = failure.tie;
  }
}

void describe(Report& report, const Replay& replay, const System& system, int digits) {
  report.digits = digits;
  report.certain_digits = certain_digits(replay.last_time(), digits);
  const double widest = replay.log10_widest();
  report.state_digits = std::isinf(widest) ? digits : std::clamp(-widest, 0.0, static_cast<double>(digits));
  report.digits_per_event = replay.events() > 0 ? (digits - report.state_digits) / static_cast<double>(replay.events()) : 0.0;
  report.end = bounds_of(replay.end(), digits);
  for (std::uint32_t i = 0; i < system.balls.size(); ++i) {
    const State<Enclosure> s = replay.state_at(i, replay.end());
    BallBounds b;
    b.index = i;
    for (std::size_t k = 0; k < static_cast<std::size_t>(system.dimension); ++k) {
      b.position.push_back(bounds_of(s.x[k], digits));
      b.velocity.push_back(bounds_of(s.v[k], digits));
    }
    report.final.push_back(b);
  }
}

}  // namespace carom::certify
