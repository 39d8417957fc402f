#include "carom/write/frame.hpp"

#include "carom/scene/growing.hpp"
#include "energy_error.hpp"

namespace carom {

namespace {

FrameBooks books_of(const Simulation& simulation) {
  const Summary s = simulation.summary();
  return {s.events.collisions(),       s.energy.final,
          s.energy.dissipated,         s.energy.injected,
          energy_error(s.energy),      energy_error_ulp(s.energy),
          s.momentum.final};
}

}  // namespace

TrajectoryFrame frame_of(const Simulation& simulation, Books books) {
  TrajectoryFrame frame{simulation.time(), simulation.balls(), std::nullopt};
  if (books == Books::kept) frame.books = books_of(simulation);
  return frame;
}

TrajectoryHead head_of(const Scene& scene, const Simulation& simulation) {
  TrajectoryHead head;
  head.title = scene.title;
  head.dimension = simulation.dimension();
  head.space = scene.space.kind;
  head.epoch_length = simulation.epoch_length();
  head.growing = balls_grow(scene);
  head.varying = scene.collision.law == LawKind::merge || head.growing;
  head.balls = static_cast<std::uint32_t>(simulation.summary().balls);
  const std::array<double, 3> periods = simulation.periods();
  if (periods[0] > 0) head.space = SpaceKind::periodic;  // a gas makes its own where none is given
  if (head.space == SpaceKind::open) return head;
  for (std::size_t k = 0; k < static_cast<std::size_t>(head.dimension); ++k) {
    head.lower[k] = k < scene.space.lower.size() ? scene.space.lower[k].value : 0.0;
    head.upper[k] = k < scene.space.upper.size() ? scene.space.upper[k].value : head.lower[k] + periods[k];
  }
  return head;
}

}  // namespace carom
