#pragma once
// Replays a given sequence of events in enclosures, and proves that nothing else happens.

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "apart.hpp"
#include "carom/certify/claim.hpp"
#include "contact.hpp"
#include "impact.hpp"
#include "tie.hpp"

namespace carom::certify {

/// What became of a claim. `event` is its number, from 1.
struct Finding {
  Proof proof = Proof::yes;
  std::int64_t event = 0;
  std::string what;          ///< why it is not proven, in words
  double log10_width = 0.0;  ///< of the enclosure of its time [time]; of what could not be told
  bool tie = false;          ///< a ball meets two at one moment, exactly: no digits will tell which comes first
};

/// It makes no decision of its own: the claims say who meets whom. It proves that each meeting happens, after those that
/// its balls had before, and that meanwhile no two bodies touch [papers/certify/README.md].
class Replay {
 public:
  /// Everything is computed in enclosures of so many decimal digits; the `Bits` of the thread must be those.
  Replay(const System& system, int digits);

  /// The next event. If it is not proven nothing is changed, so `finish` can still prove what came before.
  Finding take(const Claim& claim);

  /// Proves that nothing more happens up to `until` [time]; none: up to the last event. The replay ends with it.
  Finding finish(const std::optional<Rational>& until);

  [[nodiscard]] std::int64_t events() const { return events_; }
  [[nodiscard]] const Enclosure& last_time() const { return last_time_; }
  /// Of the parties of the last event, and of all balls at the end, once `finish` is through: [length], [length/time].
  [[nodiscard]] State<Enclosure> state_at(std::uint32_t ball, const Enclosure& time) const;
  [[nodiscard]] const Enclosure& end() const { return end_; }
  [[nodiscard]] double log10_widest() const;  ///< of the positions and velocities of all balls, relative to the largest of each

 private:
  struct Parties {
    std::uint32_t left = 0, right = 0;  ///< two balls; on a line in this order
    Apart::Period period{};             ///< of `right`, seen from `left`
    std::optional<std::size_t> piece;   ///< or a ball and a piece of a wall

    [[nodiscard]] std::vector<std::uint32_t> balls() const { return piece ? std::vector{left} : std::vector{left, right}; }
  };
  /// What a ball does after an event.
  struct Next {
    std::uint32_t ball = 0;
    Flight flight;
  };
  /// An event just proven, while another one that shares no ball with it may turn out to be at the same moment.
  struct Recent {
    std::int64_t event = 0;
    Enclosure time, latest;
    Parties parties;
  };

  [[nodiscard]] std::optional<Parties> parties_of(const Claim& claim) const;
  [[nodiscard]] std::string name(const Parties& p) const;
  [[nodiscard]] Finding report(Proof proof, std::string what, const Enclosure& width) const;
  [[nodiscard]] Finding judge_time(const Parties& p, const Claim& claim, const Enclosure& time);
  [[nodiscard]] Finding judge_order(const Parties& p, const Enclosure& time) const;
  [[nodiscard]] Finding prove_apart(const Parties& p, const Enclosure& time, int side) const;
  [[nodiscard]] Finding prove_balls(std::uint32_t i, const Flight& a, std::uint32_t j, const Flight& b, const Span& span,
                                    const KnownContact* end) const;
  [[nodiscard]] Finding prove_piece(std::uint32_t i, const Flight& a, std::size_t piece, const Span& span, const KnownContact* end) const;
  [[nodiscard]] Finding prove_either_order(const Enclosure& time, const std::vector<Next>& next) const;
  [[nodiscard]] std::vector<Next> impact(const Parties& p, const Contact& contact, int side) const;
  [[nodiscard]] std::optional<KnownContact> begun_together(std::uint32_t i, const Flight& a, std::uint32_t j, const Flight& b) const;
  [[nodiscard]] Finding tie_or(Finding f, const Parties& p, const FirstMeeting& other) const;
  void commit(const Parties& p, std::vector<Next> next, const Enclosure& time);

  const System& system_;
  int digits_;
  Apart apart_;
  Impacts impacts_;
  std::vector<Flight> flights_, before_;  // by ball: now, and before its last event
  std::deque<Recent> recent_;
  Enclosure forgotten_;  // the latest that an event no longer in recent_ can have been
  Enclosure last_time_, latest_start_, slack_, end_;
  std::int64_t events_ = 0;
};

}  // namespace carom::certify
