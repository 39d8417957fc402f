// Runs a scene in more and more digits until its log is proven.

#include <algorithm>
#include <cmath>
#include <memory>
#include <ostream>
#include <sstream>

#include "beside_double.hpp"
#include "carom/certify/certify.hpp"
#include "certificate.hpp"
#include "log.hpp"
#include "outcome.hpp"

namespace carom::certify {

namespace {

constexpr std::int64_t settle_every = 64;  // events at least; it costs a proof for every pair of balls

/// One try: a simulation and a replay of its log, event by event, in the same number of digits.
class Try {
 public:
  Try(const Scene& scene, const System& system, int digits, const Watch& watch)
      : scene_(scene), system_(system), digits_(digits), watch_(watch), bits_(bits_of_digits(digits)), replay_(system, digits) {
    for (const SystemBall& b : system.balls) radii_.push_back(nearest_double(b.radius));
    if (watch.certificate) certificate_ = &watch.certificate();
  }

  Report operator()() {
    if (certificate_ != nullptr) write_head(*certificate_, system_, digits_);
    Simulation simulation(scene_, Precision::decimal(digits_));
    BesideDouble beside(scene_, system_);
    beside_ = &beside;
    const std::array<double, 3> periods = simulation.periods();
    const Stop stop = simulation.advance(
        scene_.run.until, scene_.run.events,
        [&](const Collision& c) {
          if (halt_) return;
          const bool pair = c.kind == EventKind::ball_ball;
          take(claim_of(c, radii_[c.ball.number] + (pair ? radii_[c.partner.number] : 0.0), periods));
        },
        &halt_);
    Report report;
    const bool to_until = scene_.run.until && failure_.proof == Proof::yes && (stop == Stop::until || stop == Stop::no_events_left);
    const std::optional<Rational> until = to_until ? std::optional(exact(*scene_.run.until)) : std::nullopt;
    const Finding end = replay_.finish(until);
    if (end.proof != Proof::yes && failure_.proof == Proof::yes) failure_ = end;
    if (end.proof == Proof::yes) settle();
    judge(report, failure_, interrupted_);
    report.events = settled_;
    if (certificate_ != nullptr) write_end(*certificate_, end.proof == Proof::yes ? until : std::nullopt);
    report.stopped_by = words(stop, simulation);
    report.against_double = beside.found();
    describe(report, replay_, system_, digits_);
    if (end.proof != Proof::yes) {
      report.end = settled_end_;
      report.final.clear();
    }
    return report;
  }

 private:
  void take(Claim claim) {
    if (watch_.interrupt != nullptr && watch_.interrupt->load()) {
      interrupted_ = true;
      halt_ = true;
      return;
    }
    const Finding f = replay_.take(claim);
    if (f.proof != Proof::yes) {
      failure_ = f;
      halt_ = true;
      return;
    }
    const Enclosure& time = replay_.last_time();
    if (certificate_ != nullptr) {
      const Bounds bounds = bounds_of(time, digits_);
      claim.lower = bounds.lower;
      claim.upper = bounds.upper;
      write_event(rows_, system_, replay_.events(), claim);
    }
    const auto every = std::max(settle_every, static_cast<std::int64_t>(system_.balls.size()));
    if (replay_.events() % every == 0 && replay_.finish(std::nullopt).proof == Proof::yes) settle();
    if (beside_ != nullptr && !beside_->add(claim, place(claim, time))) beside_ = nullptr;
    if (watch_.progress) watch_.progress(replay_.events(), digits_);
  }

  /// All events up to here are proven, and that nothing else happens: what is written stands.
  void settle() {
    settled_ = replay_.events();
    settled_end_ = bounds_of(replay_.end(), digits_);
    if (certificate_ != nullptr) *certificate_ << rows_.str();
    rows_.str("");
  }

  [[nodiscard]] BesideDouble::Place place(const Claim& c, const Enclosure& time) const {
    BesideDouble::Place p;
    p.time = time.nearest();
    const auto at = [&](std::uint32_t ball, std::array<double, 3>& x) {
      const State<Enclosure> s = replay_.state_at(ball, time);
      for (std::size_t k = 0; k < 3; ++k) x[k] = s.x[k].nearest();
    };
    at(c.ball, p.ball);
    if (c.kind == MeetingKind::ball_ball) at(c.partner, p.partner);
    return p;
  }

  [[nodiscard]] static std::string words(Stop stop, const Simulation& simulation) {
    switch (stop) {
      case Stop::until: return "until";
      case Stop::events: return "events";
      case Stop::no_events_left: return "no_events_left";
      case Stop::interrupted: return "interrupted";
      case Stop::packing: return "packing";
      case Stop::pressure: return "pressure";
      default: break;
    }
    const auto stopped = simulation.summary().stopped;
    return stopped ? stopped->reason : "collapse";
  }

  const Scene& scene_;
  const System& system_;
  int digits_;
  const Watch& watch_;
  Bits bits_;
  Replay replay_;
  std::vector<double> radii_;
  std::ostream* certificate_ = nullptr;
  std::ostringstream rows_;  // since the last `settle`
  std::int64_t settled_ = 0;
  Bounds settled_end_;
  BesideDouble* beside_ = nullptr;
  std::atomic<bool> halt_{false};
  bool interrupted_ = false;
  Finding failure_;
};

}  // namespace

Report prove(const Scene& scene, const Options& options, const Watch& watch) {
  const System system = system_of(scene);
  return with_more_digits(options, options.digits, false, [&](int digits) { return Try(scene, system, digits, watch)(); });
}

}  // namespace carom::certify
