#include <cmath>

#include "carom/motion/free_flight.hpp"
#include "carom/predict/ball_wall.hpp"
#include "carom/world/flat_walls.hpp"
#include "carom/world/wall_pieces.hpp"
#include "swarm_collision.hpp"

namespace carom::detail {
namespace {

template <int D>
Ball<double, D> ball_of(const SwarmRun<D>& run, std::uint32_t i) {
  return stored_ball(run.swarm, run.swarm.past[i].number);
}

/// When ball i meets a piece, and from which side: as predict_wall in predict/ball_wall.hpp.
template <int D, class Shape>
SidedFlight<double> sided_flight(const SwarmRun<D>& run, std::uint32_t i, const Shape& shape) {
  const Ball<double, D> ball = ball_of(run, i);
  if (ball.fixed) return {never<double>(), 0};
  const Past& past = run.swarm.past[i];
  constexpr std::uint8_t held = Past::in_contact | Past::last_was_wall;
  const bool touches =
      (past.flags & held) == held && past.last_partner == index(shape.wall) && past.last_feature == shape.feature;
  const Contact<D> contact = touches ? held_contact(run.swarm, i) : Contact<D>{};
  return flight_to(FreeFlight<double, D>{}, run.swarm.rest, ball, shape, touches ? &contact : nullptr);
}

template <int D, class Shape>
bool collide_with(SwarmRun<D>& run, std::uint32_t i, const Shape& shape, const Time<double>& t) {
  const Flight<D> before = run.swarm.flights[i];
  const bool hit = (run.swarm.past[i].flags & Past::hit) != 0;
  Impact<double, D> impact;
  impact.va = vector<D>(before.v);
  impact.vb = Vec<double, D>::Zero();
  impact.ma = run.swarm.kind(i).mass;
  impact.mb = infinity<double>();
  if (infinite(impact.ma)) return false;
  std::int8_t side = 0;
  if constexpr (!std::is_same_v<Shape, Face<double, D>>) side = sided_flight(run, i, shape).side;
  const Vec<double, D> x = flown_to(before, t);
  const double radius = run.swarm.kind(i).radius;
  const WallTouch<double, D> place = touch_at<double, D>(shape, x, radius, side);
  impact.r = place.into_wall;
  const double gap = note_gap(run.exactness, place.gap, radius);
  const std::uint32_t wall = index(shape.wall);
  const bool flat = flat_number(run.swarm.rest.walls, shape) != 0;
  impact.e = restitution_at_wall(run, impact, i, wall, flat, t);
  const Outcome<double, D> outcome = resolve_impact(impact);
  write(run, i, x, outcome.va, t);
  Past& past = run.swarm.past[i];
  past.flags = Past::hit | Past::in_contact | Past::last_was_wall;
  past.contact_image = static_cast<std::uint8_t>(side + 1);
  past.last_partner = wall;
  past.last_feature = shape.feature;
  past.partner_stamp = 0;
  ++run.counts.ball_wall;
  book(run.books, outcome);
  if (run.sink != nullptr) {
    Event<double, D> event;
    event.time = t;
    event.kind = EventKind::ball_wall;
    event.ball = run.swarm.past[i].number;
    event.partner = wall;
    event.feature = shape.feature;
    event.side = side;
    send(run, event, impact, outcome, gap, i, hit, before.time(), i, false, before.time(),
         [&](Record<double, D>& record) { fill_place(record, shape, x, radius, side); });
  }
  for (int k = 0; k < D; ++k)
    if (!(outcome.va[k] - outcome.va[k] == 0)) run.verdict = Halt::non_finite;
  if (run.verdict == Halt::until)
    watch(run, impact, t, outcome.impulse, i, {run.swarm.past[i].number}, flat ? Support::corner : Support::curve);
  return true;
}

}  // namespace

template <int D>
double flight_to_piece(const SwarmRun<D>& run, std::uint32_t i, std::size_t piece) {
  double flight = never<double>();
  with_piece(run.swarm.rest.walls, piece, [&](const auto& shape) { flight = sided_flight(run, i, shape).flight; });
  return flight;
}

template <int D>
bool reaches_walls(const SwarmRun<D>& run, std::uint32_t i, const double* x, double stray) {
  const Vec<double, D> centre = vector<D>(x);
  const double reach = run.swarm.kind(i).radius + 2 * stray;
  bool near = false;
  for (std::size_t f = run.swarm.rest.walls.faces.size(); f < run.pieces && !near; ++f)
    with_piece(run.swarm.rest.walls, f, [&](const auto& shape) { near = !(shape.gap(centre) > reach); });
  return near;
}

template <int D>
bool collide_with_wall(SwarmRun<D>& run, std::uint32_t i, std::size_t piece, const Time<double>& t) {
  bool done = false;
  with_piece(run.swarm.rest.walls, piece, [&](const auto& shape) { done = collide_with(run, i, shape, t); });
  return done;
}

template double flight_to_piece(const SwarmRun<2>&, std::uint32_t, std::size_t);
template double flight_to_piece(const SwarmRun<3>&, std::uint32_t, std::size_t);
template bool reaches_walls(const SwarmRun<2>&, std::uint32_t, const double*, double);
template bool reaches_walls(const SwarmRun<3>&, std::uint32_t, const double*, double);
template bool collide_with_wall(SwarmRun<2>&, std::uint32_t, std::size_t, const Time<double>&);
template bool collide_with_wall(SwarmRun<3>&, std::uint32_t, std::size_t, const Time<double>&);

}  // namespace carom::detail
