#pragma once
// What a run of many balls holds, and what the loop leaves to others: whatever is rare.

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "carom/core/pages.hpp"
#include "carom/law/elastic.hpp"
#include "carom/queue/calendar.hpp"
#include "carom/search/shells.hpp"
#include "carom/sim/books.hpp"
#include "carom/sim/collapse_watch.hpp"
#include "carom/sim/record.hpp"
#include "carom/sim/stop.hpp"
#include "carom/world/swarm.hpp"

namespace carom {

/// Why the loop handed back.
enum class Halt : std::uint8_t {
  until,        ///< the next event lies later
  events,       ///< so many collisions have happened
  idle,         ///< nothing is due
  interrupted,  ///< by the user
  unusual,      ///< the next event is one that only EventDriven knows: a second one of a ball at one moment
  collapse,     ///< see SwarmRun::watch
  non_finite
};

/// Work that was done: not part of the log.
struct SwarmWork {
  std::int64_t predictions = 0;  ///< pairs whose meeting was asked for
  std::int64_t renewals = 0;     ///< shells left
  std::int64_t rescans = 0;      ///< lists gone through anew because both candidates had become stale
  std::int64_t drained = 0;      ///< entries taken from the calendar
  std::int64_t due = 0;          ///< those among them that were not stale
  std::int64_t buckets = 0;      ///< of the calendar, that were not empty
};

/// A ball that is due in the bucket at hand.
struct Due {
  Time<double> time;
  std::uint32_t ball, partner;
};

template <int D>
struct SwarmRun {
  Swarm<D> swarm;
  Shells<D> shells;
  Calendar calendar;
  PageArray<Due> agenda;  ///< of the bucket at hand, in order; from `head` on they are still to come
  std::size_t head = 0;
  PageArray<Due> drained;        ///< the same as they came from the calendar
  PageArray<std::uint8_t> bins;  ///< room for sorting

  Time<double> now;    ///< of the last collision
  Time<double> clock;  ///< of what was dealt with last: all balls are in their shells then
  EventCounts counts;
  Exactness<double> exactness;
  EnergyBooks<double> books;
  CollapseWatch<double> watch;
  SwarmWork work;

  double mean_free_time = 0;   ///< [L] of a ball, as measured last
  double per_bucket = 24;      ///< balls wanted in a fine bucket
  std::int64_t next_tuning = 0;  ///< bucket after which the width is judged again
  std::int64_t tuned_due = 0, tuned_buckets = 0, tuned_collisions = 0;  ///< counts at the last judgement
  Time<double> tuned_at;
  bool far_sighted = false;    ///< fetches the records of coming events ahead: more than the cache holds
  bool plain = true;           ///< every impact is elastic, no mass infinite: the loop resolves it itself
  std::int64_t quiet = 0;      ///< shells left since the last collision
  Halt verdict = Halt::until;  ///< of the last collision, if it was its last
  std::string reason;                       ///< of a verdict `collapse` or `non_finite`
  std::vector<std::uint32_t> reason_balls;  ///< their numbers

  void (*sink)(void*, const Record<double, D>&) = nullptr;  ///< wants a record of each collision
  void* sink_data = nullptr;
  struct {
    Flight<D> first, second;
    bool first_hit, second_hit;  ///< they had collided before
  } before;                      ///< how the parties of the collision at hand came; where there is a sink

  std::size_t pieces = 0;              ///< of walls that stand still, faces of the space first: world/wall_pieces.hpp
  PageArray<std::uint8_t> near_walls;  ///< by row: its shell reaches a piece that is no face; empty where there is none

  double reach = 0;  ///< [length unit] centres of neighbours are closer, whatever the ball
  ElasticPair pair;  ///< any two balls, where all are alike
};

/// The loop, compiled for one instruction set and one kind of swarm.
template <int D>
struct SwarmKernel {
  /// Lists, predictions and calendar of a swarm as it is at run.now.
  void (*start)(SwarmRun<D>&);
  Halt (*advance)(SwarmRun<D>&, const Time<double>& until, std::int64_t goal, const std::atomic<bool>* interrupt);
};

/// The best that this machine can run; all give the same bits. `vectors` false: without vector instructions.
template <int D>
[[nodiscard]] SwarmKernel<D> swarm_kernel(const Swarm<D>& swarm, bool vectors = true);

namespace detail {

/// Flight of balls i and j (its image) to their meeting, from the moment that r and v (of j relative to i) belong to:
/// whatever the quick path could not settle. Balls that touch do so in one image, and may meet in another.
template <int D>
[[nodiscard]] double careful_flight(const SwarmRun<D>& run, std::uint32_t i, std::uint32_t j, const double* image,
                                    const double* r, const double* v, double sigma);

/// Two predicted events of ball i at one moment, with partners p and q: true if the one with p comes first.
template <int D>
[[nodiscard]] bool first_at_a_tie(const SwarmRun<D>& run, std::uint32_t i, std::uint32_t p, std::uint32_t q);
/// The same for what is due for two balls.
template <int D>
[[nodiscard]] bool first_due_at_a_tie(const SwarmRun<D>& run, std::uint32_t i, std::uint32_t k);

/// Periods to take out of x: as wrap() in world/state.hpp.
[[nodiscard]] int wrap_coordinate(double lower, double edge, double& x);

/// Judges the width of the calendar's buckets, and makes it anew if it is far off.
template <int D>
void tune_calendar(SwarmRun<D>& run);
/// Enters all balls in a calendar with a width that suits them. False if nothing is due for any.
template <int D>
bool refill_calendar(SwarmRun<D>& run);

/// A collision with all that the laws may ask for. Returns false if nothing was changed: only EventDriven knows this one.
template <int D>
bool collide_carefully(SwarmRun<D>& run, std::uint32_t i, std::uint32_t partner, const Time<double>& t);

/// Flight of ball i from its stored state to a piece of a wall, by the number of the piece; and a collision with one, as above.
template <int D>
[[nodiscard]] double flight_to_piece(const SwarmRun<D>& run, std::uint32_t i, std::size_t piece);
template <int D>
bool collide_with_wall(SwarmRun<D>& run, std::uint32_t i, std::size_t piece, const Time<double>& t);
/// False if ball i cannot touch any piece that is no face in a shell about x, from which it may stray so far.
template <int D>
[[nodiscard]] bool reaches_walls(const SwarmRun<D>& run, std::uint32_t i, const double* x, double stray);

/// Hands the sink a record of the elastic collision of i and j (its image) at t that has just been carried out; run.before
/// tells how they came.
template <int D>
void report_collision(SwarmRun<D>& run, std::uint32_t i, std::uint32_t j, const Time<double>& t, const double* image);

}  // namespace detail
}  // namespace carom
