#pragma once
// What a run of few balls holds, and what its loop leaves to others: whatever is rare.

#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <vector>

#include "carom/law/elastic.hpp"
#include "carom/motion/free_flight.hpp"
#include "carom/predict/next_circles.hpp"
#include "carom/search/near_walls.hpp"
#include "carom/sim/collision.hpp"
#include "carom/sim/stop.hpp"
#include "carom/world/world.hpp"

namespace carom {

/// Why the loop handed back.
enum class FewHalt : std::uint8_t {
  until,        ///< the next event lies later
  events,       ///< so many collisions have happened
  idle,         ///< nothing is due
  interrupted,  ///< by the user
  unusual,      ///< what is next is for EventDriven: two events at one moment, or a flight without end
  collapse,     ///< see Collider::reason
  non_finite
};

/// An impact that the loop has carried out itself, for a record of it.
template <int D>
struct FewImpact {
  Time<double> time;
  std::uint32_t low = 0, high = 0;  ///< two balls, or twice the ball that has hit a wall
  Image<D> image{};                         ///< of the partner, relative to the places before
  double at[2][D] = {}, before[2][D] = {};  ///< places, not wrapped, and velocities before, of low and high
  Time<double> previous[2];                 ///< their previous collisions
  double from_wall[D] = {};                 ///< normal of the wall, of any length
  std::int8_t side = 0;                     ///< of the wall
  double impulse = 0;
};

/// Balls in free flight, so few that the next meeting of every pair, and of every ball with the walls, is kept in a table: no
/// event is ever stale, and the first is found by looking at all. The world is that of EventDriven and is kept as that keeps
/// it, so either can go on from where the other stopped.
template <int D>
struct FewRun {
  using Motion = FreeFlight<double, D>;
  static constexpr std::uint32_t most_balls = 16;
  static constexpr std::uint32_t most_slots = most_balls * (most_balls + 1) / 2;
  static constexpr std::uint32_t no_slot = ~std::uint32_t{0};
  static constexpr std::uint32_t some_wall = ~std::uint32_t{0};  ///< the wall is told by Wall::event

  /// Two balls, low < high, or a ball and what it meets first of all walls: then high = low.
  struct Slot {
    std::uint32_t low = 0, high = 0;
    double column = 0;     ///< of a path through a lattice that is not looked at to its end: where to go on
    bool settled = true;   ///< false: the flight only leads up to that column
    Image<D> image{};      ///< of ball high relative to ball low
    ElasticPair pair{};
  };
  /// What a ball meets first of all walls.
  struct Wall {
    std::uint32_t which = 0;  ///< 2 * axis + side of a face, 2 D + row of spheres, or some_wall
    bool tied = false;        ///< it meets two at that moment
    Event<double, D> event;   ///< some_wall
    const Segment<double>* segment = nullptr;  ///< some_wall, where the loop can carry out the impact: one of these
    const Arc<double>* arc = nullptr;
    Image<D> image{};         ///< of the sphere, in a periodic space
    double centre[D] = {};    ///< where it stands there
    Image<D> tile{};          ///< of a path that is not looked at to its end: the period where to go on
  };

  World<double, D>* world = nullptr;
  Collider<Motion>* collider = nullptr;
  Verdict (*collide)(FewRun&, const Event<double, D>&) = nullptr;  ///< by the law's own code; tells the sink, if there is one
  void* sink = nullptr;
  void (*tell)(FewRun&) = nullptr;  ///< tells the sink of what the loop has done; null: it wants no records
  FewImpact<D> told;                ///< what that was
  bool plain = false;  ///< the loop itself can carry out impacts

  Time<double> now;  ///< of the last collision
  std::uint32_t slots = 0;
  double edge[D], per_edge[D];                 ///< periodic
  std::array<double, 2 * D> face{};            ///< coordinates by axis and side, lower first; infinite: there is none
  std::array<std::int32_t, 2 * D> face_row{};  ///< of walls.faces; -1: none
  std::vector<std::uint32_t> spheres;          ///< rows of walls.spheres that stand still, with a radius
  std::array<std::vector<ElasticPair>, most_balls> sphere_pair;  ///< by ball and row of `spheres`
  bool other_walls = false;
  bool flat_or_round = false;  ///< the other walls are segments, arcs and vertices at rest
  std::array<ElasticPair, most_balls> flat_pair{};                       ///< by ball: r is a unit normal
  std::array<std::vector<std::array<ElasticPair, 2>>, most_balls> arc_pair;  ///< by ball and row of walls.arcs: outside, inside
  NearWalls<double, D> near_walls;             ///< of a period of a periodic space
  /// In a periodic plane, by radius of the balls: of the spheres, and of the balls that are fixed. Made when a run turns out to be
  /// so long that they pay.
  std::vector<NextCircles> next_circles, next_fixed;
  std::array<std::uint32_t, most_balls> circles_of{};  ///< rows of both, by ball
  std::vector<std::uint32_t> fixed;                    ///< ball numbers, by row of the circles of next_fixed
  std::array<std::uint32_t, most_balls> fixed_row{};   ///< by ball; those that are not in `fixed`: beyond all rows
  std::uint32_t without_circles = 0, without_fixed = 0;  ///< how often they would have been asked
  std::int64_t passages = 0;  ///< columns gone through since the last collision

  std::array<Slot, most_slots> slot{};
  std::array<Wall, most_balls> wall{};
  alignas(32) std::array<double, most_slots + 4> flight{};  ///< [L] by slot, from the later of the stored times; or `never`
  alignas(32) std::array<double, most_slots + 4> due{};     ///< [L] the same from the beginning of epoch `base`, rounded
  std::int64_t base = 0;
  std::array<std::array<std::uint32_t, most_balls>, most_balls> slot_of{};  ///< of a pair, of a ball's walls (i, i)
  std::array<std::array<std::uint32_t, most_balls>, most_balls> others{};   ///< partners of a ball, padded with itself
  std::array<std::uint32_t, most_balls> other_count{};
  std::array<std::array<double, most_balls>, most_balls> sigma{};           ///< with others[i][k]
};

/// yes ? a : b, without a branch: for what cannot be foreseen.
[[nodiscard]] CAROM_INLINE double choice(bool yes, double a, double b) {
  const std::uint64_t mask = -static_cast<std::uint64_t>(yes);
  return std::bit_cast<double>((std::bit_cast<std::uint64_t>(a) & mask) | (std::bit_cast<std::uint64_t>(b) & ~mask));
}

/// `after` of core/clock.hpp, with its choices made so.
[[nodiscard]] CAROM_INLINE Time<double> after_without_branches(const Time<double>& t, double flight) {
  if (!(flight < 0x1p62)) return Time<double>::never();
  const std::int64_t whole = static_cast<std::int64_t>(flight);
  const double part = flight - static_cast<double>(whole), past = part + (t.offset - 1), both = t.offset + part;
  const bool over = past >= 0, next = over | (both >= 1);
  const double offset = choice(over, past, choice(next, 0.0, both)), on_grid = (offset + 0.5) - 0.5;
  const Time<double> sum{t.epoch + whole + static_cast<std::int64_t>(next), choice(offset < 0.5, on_grid, offset)};
  if (sum.epoch > last_epoch || sum.epoch < t.epoch) return Time<double>::never();
  return sum;
}

/// When the event of a slot happens: a function of the stored states.
template <int D>
[[nodiscard]] CAROM_INLINE Time<double> time_of(const FewRun<D>& run, std::uint32_t s) {
  const typename FewRun<D>::Slot& slot = run.slot[s];
  if (slot.low == slot.high && run.wall[slot.low].which == FewRun<D>::some_wall) return run.wall[slot.low].event.time;
  const Time<double>&a = run.world->balls[slot.low].time, &b = run.world->balls[slot.high].time;
  return after_without_branches(a < b ? b : a, run.flight[s]);
}

/// A loop for one instruction set.
template <int D>
using FewKernel = FewHalt (*)(FewRun<D>&, const Time<double>& until, std::int64_t goal, const std::atomic<bool>* interrupt);

/// The fastest loop for this world here. `vectors`: may use the vector unit; that changes no bit.
template <int D>
[[nodiscard]] FewKernel<D> few_kernel(const World<double, D>& world, bool vectors);

namespace detail {

/// Sets the flight of a slot that is counted from `since`.
template <int D>
inline void set_flight(FewRun<D>& run, std::uint32_t slot, double flight, const Time<double>& since) {
  run.flight[slot] = flight;
  run.due[slot] = (static_cast<double>(since.epoch - run.base) + since.offset) + flight;
}

/// Sorts the walls of a world into those that the loop knows and others.
template <int D>
void plan_walls(FewRun<D>& run, const World<double, D>& world);

/// Looks at what stands still in a periodic world, once for the whole run.
template <int D>
void survey(FewRun<D>& run, const World<double, D>& world);

/// Makes next_circles, or next_fixed, once they have been missed often enough.
void miss_circles(FewRun<2>& run);
void miss_fixed(FewRun<2>& run);

/// Fills the table of a world anew; `collider` books what happens in it.
template <int D>
void start_few(FewRun<D>& run, World<double, D>& world, Collider<FreeFlight<double, D>>& collider, const Time<double>& now);

/// Predicts a pair, whatever their contacts and however close; goes on from the column of an unsettled slot.
template <int D>
void predict_pair(FewRun<D>& run, std::uint32_t slot);

/// Flight of a pair to its meeting in one image.
template <int D>
[[nodiscard]] double flight_to_image(const FewRun<D>& run, std::uint32_t slot, const Image<D>& image);

/// Predicts the walls of ball i, whatever its contacts; goes on from the period of an unsettled slot.
template <int D>
void predict_walls(FewRun<D>& run, std::uint32_t i);

/// Flight of ball i to a sphere that plain arithmetic does not settle.
template <int D>
[[nodiscard]] double flight_to_sphere(const FewRun<D>& run, std::uint32_t i, std::uint32_t row);

/// Flight of a ball to a circle that stands still and that it does not touch.
[[nodiscard]] double flight_to_circle(const Ball<double, 2>& ball, double x, double y, double sigma);

/// Puts the first meeting of ball i with walls that the loop does not predict itself into its entry.
template <int D>
void find_other_wall(FewRun<D>& run, std::uint32_t i);

/// Ball i, a point that is to be stored at x after an impact with the wall that stands in its entry, is certainly not stored so
/// close to another that rounding may have carried it across (sim/sides.hpp).
template <int D>
[[nodiscard]] bool stays_clear(const FewRun<D>& run, std::uint32_t i, const double* x);

/// The first of all slots that are due by `limit` or by what rounding may have made of it, by their exact times; `tied`: two
/// come at one moment.
template <int D>
[[nodiscard]] std::uint32_t first_of_close(const FewRun<D>& run, double limit, bool& tied);

/// Carries out the event of a slot by the law's own code.
template <int D>
[[nodiscard]] Verdict collide_slot(FewRun<D>& run, std::uint32_t slot, const Time<double>& t);

/// The times of slots are counted from the epoch of `run.now` on.
template <int D>
void rebase(FewRun<D>& run);

/// The list of contacts of a ball gets one entry.
template <int D>
void one_contact(BallDetail<double, D>& detail);

}  // namespace detail

}  // namespace carom
