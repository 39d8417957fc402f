#pragma once
// A proof of the order of events of a scene: by whom it is made, what it says, and how it is checked.

#include <atomic>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "carom/scene/scene.hpp"

namespace carom::certify {

struct Options {
  int digits = 50;          ///< decimal digits of the first try. DEFAULT: 50
  int max_digits = 12'800;  ///< of the last one; each has twice as many as the one before. DEFAULT: 12 800
};

enum class Verdict : std::uint8_t {
  proven,       ///< all of it
  undecided,    ///< `events` of them; what comes next cannot be told, even in the last try
  refuted,      ///< `events` of them; the next one of the log is wrong
  interrupted,  ///< `events` of them
};

/// Decimals, rounded outwards.
struct Bounds {
  std::string lower, upper;
};

struct BallBounds {
  std::uint32_t index = 0;
  std::vector<Bounds> position;  ///< [length] not wrapped
  std::vector<Bounds> velocity;  ///< [length/time]
};

/// A collision of the run in double precision: its number, from 1, and its time.
struct Mark {
  std::int64_t event = 0;
  double time = 0.0;
};

/// The run in double precision of the same scene beside the proven one.
struct AgainstDouble {
  std::int64_t compared = 0;       ///< its collisions, each with the proven one that it stands for
  double length = 0.0;             ///< [length] smallest radius there is; without any: smallest edge
  double largest_error = 0.0;      ///< [length] of the place of a colliding ball, while all met whom they should
  std::optional<Mark> off;         ///< first collision at which a ball is more than length / 100 from its proven place
  std::optional<Mark> different;   ///< first collision that its ball does not have in the proof
};

struct Report {
  Verdict verdict = Verdict::proven;
  std::int64_t events = 0;        ///< proven: they happen, in this order, and nothing else before `end`
  std::int64_t at_event = 0;      ///< of a verdict that is not proven: the event in question
  std::string what;               ///< and the reason, in words
  double log10_width = 0.0;       ///< of what could not be told
  bool tie = false;               ///< a ball meets two at one moment, exactly: more digits will not tell
  std::string stopped_by;         ///< of the log: "until", "events", "no_events_left", or what it stopped at
  int digits = 0;                 ///< of the last try
  int tries = 0;
  double certain_digits = 0.0;    ///< of the last event's time
  double state_digits = 0.0;      ///< of positions and velocities, of the largest of each, after the last event
  double digits_per_event = 0.0;  ///< lost, of the state
  Bounds end;                     ///< [time] up to which it is proven
  std::vector<BallBounds> final;  ///< all balls, there
  std::optional<AgainstDouble> against_double;
};

/// What a proof needs from outside.
struct Watch {
  std::function<std::ostream&()> certificate;                  ///< an empty file, anew for each try; none: no certificate
  std::function<void(std::int64_t events, int digits)> progress;
  const std::atomic<bool>* interrupt = nullptr;
};

/// Runs the scene in as many digits as it takes, and proves its log to the end that the scene gives. Throws InputError: a
/// scene that no proof is made for, or a library without MPFI.
[[nodiscard]] Report prove(const Scene& scene, const Options& options, const Watch& watch = {});

/// Proves what a certificate says, from the file alone: the sequence, each time in its enclosure, and that nothing else
/// happens. `digits` of `options` are raised to what the certificate was made with. `scene`, if given, must be the one that
/// it is about. Throws InputError if the file is no certificate, or one of another scene.
[[nodiscard]] Report verify(std::istream& certificate, const Options& options, const Watch& watch = {},
                            const Scene* scene = nullptr);

}  // namespace carom::certify
