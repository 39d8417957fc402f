#pragma once
// The integrator for few balls, and EventDriven for what it leaves to that: both move one world.

#include <algorithm>
#include <limits>
#include <memory>
#include <span>
#include <utility>

#include "carom/queue/heap_queue.hpp"
#include "carom/sim/event_driven.hpp"
#include "carom/sim/few_run.hpp"

namespace carom {

template <int D, class Search>
class FewIntegrator {
 public:
  using Motion = FreeFlight<double, D>;

  /// What it takes beside a world and a motion.
  struct Setup {
    Search search;
    bool vectors = true;
  };

  FewIntegrator(World<double, D>&& world, const Motion& motion, Setup setup)
      : world_(std::move(world)), engine_(world_, motion, std::move(setup.search)), kernel_(few_kernel(world_, setup.vectors)) {
    detail::survey_walls(*run_, world_);
    go_on(world_.start);
  }
  FewIntegrator(const FewIntegrator&) = delete;
  FewIntegrator& operator=(const FewIntegrator&) = delete;

  template <class Sink>
  Stop advance(const Time<double>& until, std::int64_t collisions, Sink&& sink, const std::atomic<bool>* interrupt) {
    using Plain = std::remove_cvref_t<Sink>;
    const std::int64_t had = counts().collisions();
    const std::int64_t goal =
        collisions < std::numeric_limits<std::int64_t>::max() - had ? had + collisions : std::numeric_limits<std::int64_t>::max();
    Plain own = sink;
    run_->sink = &own;
    run_->collide = [](FewRun<D>& run, const Event<double, D>& event) {
      Plain& to = *static_cast<Plain*>(run.sink);
      const Verdict verdict = run.collider->collide(*run.world, Motion{}, event, to);
      if constexpr (requires { to.moved(run.collider->moved()); }) to.moved(run.collider->moved());
      return verdict;
    };
    run_->plain = !Plain::wants_records && simple_;
    while (true) {
      if (aside_) {
        const std::int64_t left = goal - counts().collisions();
        const Stop stop = engine_.advance(until, std::min(left, patience), sink, interrupt);
        if (stop != Stop::events || left <= patience) return stop;
        go_on(engine_.now());
      }
      switch (kernel_(*run_, until, goal, interrupt)) {
        case FewHalt::until: return Stop::until;
        case FewHalt::events: return Stop::events;
        case FewHalt::idle: return Stop::no_events_left;
        case FewHalt::interrupted: return Stop::interrupted;
        case FewHalt::collapse: return Stop::collapse;
        case FewHalt::non_finite: return Stop::non_finite;
        case FewHalt::unusual: step_aside(); break;
      }
    }
  }

  void reverse(const Time<double>& t) {
    engine_.reverse(t);
    aside_ = true;
  }
  [[nodiscard]] const Time<double>& now() const { return aside_ ? engine_.now() : run_->now; }
  [[nodiscard]] const World<double, D>& world() const { return world_; }
  [[nodiscard]] World<double, D> copy() const { return world_; }
  [[nodiscard]] const Collider<Motion>& ledger() const { return engine_.collider(); }
  [[nodiscard]] StopDetail reason() const { return {engine_.collider().reason, engine_.collider().reason_balls, {}}; }
  void restore(World<double, D>&& world, Collider<Motion>&& ledger, const Time<double>& now) {
    world_ = std::move(world);
    engine_.collider() = std::move(ledger);
    go_on(now);
  }

 private:
  /// Collisions that EventDriven carries out before things are taken to be usual again.
  static constexpr std::int64_t patience = 64;

  [[nodiscard]] const EventCounts& counts() const { return engine_.collider().counts; }

  void go_on(const Time<double>& now) {
    aside_ = false;
    detail::start_few(*run_, world_, engine_.collider(), now);
    bool points = false;
    for (const auto& ball : world_.balls) points = points || !(ball.radius > 0);
    simple_ = !world_.restitution.any_below_one() && !(points && run_->other_walls);
  }
  void step_aside() {
    aside_ = true;
    engine_.resume(run_->now);
  }

  World<double, D> world_;
  EventDriven<Motion, Search, HeapQueue<double, D>> engine_;
  FewKernel<D> kernel_;
  std::unique_ptr<FewRun<D>> run_ = std::make_unique<FewRun<D>>();
  bool aside_ = false;   // EventDriven has the run
  bool simple_ = false;  // impacts are elastic, and no point has sides of walls to be kept on (sim/sides.hpp)
};

}  // namespace carom
