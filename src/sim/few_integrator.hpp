#pragma once
// The integrator for few balls, and EventDriven for what it leaves to that: both move one world.

#include <algorithm>
#include <array>
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
    detail::survey(*run_, world_);
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
    run_->tell = nullptr;
    if constexpr (Plain::wants_records)
      run_->tell = [](FewRun<D>& run) { tell(run, *static_cast<Plain*>(run.sink)); };
    run_->plain = simple_;
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

  /// The record that EventDriven would have made of an elastic impact, whose parties have been written.
  template <class Sink>
  static void tell(const FewRun<D>& run, Sink& sink) {
    using Vector = Vec<double, D>;
    const FewImpact<D>& told = run.told;
    const World<double, D>& world = *run.world;
    const BallDetail<double, D>& detail = world.details[told.low];
    const bool pair = told.low != told.high;
    const auto vector = [](const double (&x)[D]) { return Vector(Eigen::Map<const Vector>(x)); };
    const double radius = world.balls[told.low].radius;
    Event<double, D> event;
    event.time = told.time;
    event.kind = pair ? EventKind::ball_ball : EventKind::ball_wall;
    event.ball = told.low;
    event.partner = detail.last_partner;
    event.feature = detail.last_feature;
    event.image = told.image;
    Impact<double, D> impact;
    impact.va = vector(told.before[0]);
    impact.vb = pair ? vector(told.before[1]) : Vector(Vector::Zero());
    impact.e = 1;
    for (int k = 0; k < D; ++k) {
      impact.r[k] = pair ? wide_difference<double>(told.at[1][k], told.at[0][k]) : DoubleDouble(-told.from_wall[k]);
      if (pair && world.space.periodic())
        impact.r[k] = impact.r[k] + wide_product<double>(double(told.image[k]), world.space.edge[k]);
    }
    Outcome<double, D> outcome{};
    outcome.va = world.balls[told.low].velocity;
    outcome.vb = pair ? Vector(world.balls[told.high].velocity) : impact.vb;
    outcome.impulse = told.impulse;
    Record<double, D> record = record_of(event, impact, outcome, 0.0, false);
    fill_party(record.ball, world, told.low, told.previous[0]);
    if (pair) {
      record.gap = gap_of_pair<double>(impact.r, double(radius + world.balls[told.high].radius));
      fill_party(record.partner, world, told.high, told.previous[1]);
    } else {
      record.partner.number = event.partner;
      with_wall(world, event.partner, event.feature, event.image, [&](const auto&, const auto& placed) {
        record.gap = touch_at<double, D>(placed, vector(told.at[0]), radius, told.side).gap;
        fill_place(record, placed, vector(told.at[0]), radius, told.side);
      });
    }
    record.partner.velocity_before = impact.vb;
    record.partner.velocity_after = outcome.vb;
    record.point = world.balls[told.low].position - record.normal * radius;
    sink(record);
    const std::array<std::uint32_t, 2> moved{told.low, told.high};
    if constexpr (requires { sink.moved(moved); }) sink.moved(std::span(moved).first(pair ? 2 : 1));
  }

  void go_on(const Time<double>& now) {
    aside_ = false;
    detail::start_few(*run_, world_, engine_.collider(), now);
    simple_ = !world_.restitution.any_below_one();
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
  bool simple_ = false;  // impacts are elastic
};

}  // namespace carom
