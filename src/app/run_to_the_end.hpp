#pragma once
// Takes a simulation to the end of its run, frame by frame and in slices short enough for somebody who watches.

#include <atomic>
#include <functional>

#include "carom/observe/samplers.hpp"
#include "carom/scene/scene.hpp"
#include "carom/sim/simulation.hpp"

namespace carom::app {

struct Watchers {
  CollisionSink collision;                       ///< every collision
  std::function<void()> frame;                   ///< at the start, at each sample or event, and at the end; none: no frames
  FramesAt frames_at = FramesAt::samples;
  Samplers* samplers = nullptr;                  ///< looks at the simulation when it wants to
  std::function<void()> slice;                   ///< a few times a second
  const std::atomic<bool>* interrupt = nullptr;  ///< ends the run at the next event
};

/// The run that `run` asks for, or the rest of it. Its events, and where it ends, do not depend on who watches. Without
/// `until`, a run that has no events left ends at its last event, though frames may have gone beyond it.
Stop run_to_the_end(Simulation& simulation, const RunSpec& run, const Watchers& watchers);

}  // namespace carom::app
