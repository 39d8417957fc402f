#pragma once
// The integrator for many balls, and EventDriven for what it leaves to that.

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>

#include "carom/motion/free_flight.hpp"
#include "carom/queue/heap_queue.hpp"
#include "carom/search/cell_grid.hpp"
#include "carom/sim/event_driven.hpp"
#include "carom/sim/swarm_run.hpp"
#include "carom/world/swarm.hpp"
#include "carom/world/swarm_maker.hpp"
#include "carom/world/wall_pieces.hpp"
#include "shell_sizes.hpp"

namespace carom {

/// A swarm, or a world, looked at through the members of World. Balls and details of a swarm are values made when asked for.
template <int D>
class SwarmView {
 public:
  class Balls {
   public:
    explicit Balls(const SwarmView& view) : view_(view) {}
    [[nodiscard]] std::size_t size() const { return view_.size(); }
    [[nodiscard]] Ball<double, D> operator[](std::size_t i) const {
      return view_.swarm_ != nullptr ? stored_ball(*view_.swarm_, static_cast<std::uint32_t>(i)) : view_.whole_.balls[i];
    }
    [[nodiscard]] Ball<double, D> at(std::size_t i) const {
      if (i >= size()) throw std::out_of_range("no such ball");
      return (*this)[i];
    }

   private:
    const SwarmView& view_;
  };
  class Details {
   public:
    explicit Details(const SwarmView& view) : view_(view) {}
    [[nodiscard]] std::size_t size() const { return view_.size(); }
    [[nodiscard]] BallDetail<double, D> operator[](std::size_t i) const {
      return view_.swarm_ != nullptr ? stored_detail(*view_.swarm_, static_cast<std::uint32_t>(i)) : view_.whole_.details[i];
    }
    [[nodiscard]] BallDetail<double, D> at(std::size_t i) const {
      if (i >= size()) throw std::out_of_range("no such ball");
      return (*this)[i];
    }

   private:
    const SwarmView& view_;
  };

  /// `swarm` null: all is in `whole`; else the balls are in the swarm and the rest is in `whole`.
  SwarmView(const Swarm<D>* swarm, const World<double, D>& whole)
      : units(whole.units),
        start(whole.start),
        balls(*this),
        details(*this),
        bodies(whole.bodies),
        walls(whole.walls),
        space(whole.space),
        acceleration(whole.acceleration),
        magnetic(whole.magnetic),
        growth(whole.growth),
        restitution(whole.restitution),
        law(whole.law),
        simultaneous(whole.simultaneous),
        regularise(whole.regularise),
        contact_time(whole.contact_time),
        reference_speed(whole.reference_speed),
        swarm_(swarm),
        whole_(whole) {}
  using Real = double;
  static constexpr int dimension = D;
  SwarmView(const SwarmView&) = delete;
  SwarmView& operator=(const SwarmView&) = delete;

  const Units& units;
  const Time<double>& start;
  const Balls balls;
  const Details details;
  const std::vector<Body<double, D>>& bodies;
  const Walls<double, D>& walls;
  const Space<double, D>& space;
  const Vec<double, D>& acceleration;
  const double magnetic;
  const Growth<double>& growth;
  const RestitutionTable<double>& restitution;
  const LawKind law;
  const Simultaneous simultaneous;
  const Regularise regularise;
  const double contact_time, reference_speed;

  [[nodiscard]] bool accelerated() const { return false; }
  [[nodiscard]] bool curved() const { return false; }

 private:
  [[nodiscard]] std::size_t size() const { return swarm_ != nullptr ? swarm_->size() : whole_.balls.size(); }

  const Swarm<D>* swarm_;
  const World<double, D>& whole_;
};

template <int D>
[[nodiscard]] SwarmView<D> as_world(const Swarm<D>& swarm) {
  return SwarmView<D>(&swarm, swarm.rest);
}

/// What a run of many balls is set up with.
struct SwarmSetup {
  double neighbours = 0;  ///< balls that a shell's reach holds on average: sets the thickness; 0: best_neighbours
  bool vectors = true;
};

template <int D>
[[nodiscard]] inline BallSizes sizes_of(const Swarm<D>& swarm) {
  BallSizes sizes;
  for (std::uint32_t i = 0; i < swarm.size(); ++i) sizes.add(swarm.kind(i).radius);
  return sizes;
}
template <int D>
[[nodiscard]] inline BallSizes sizes_of(const WorldAndGases<D>& parts) {
  BallSizes sizes;
  for (const auto& ball : parts.world.balls) sizes.add(ball.radius);
  for (const GasBalls& gas : parts.gases) sizes.add(gas.radius, gas.position.size() / static_cast<std::size_t>(D));
  return sizes;
}

template <int D>
class SwarmIntegrator {
 public:
  using Motion = FreeFlight<double, D>;
  using Ledger = Collider<Motion>;

  SwarmIntegrator(Swarm<D>&& swarm, const Motion&, SwarmSetup setup) : setup_(setup) {
    run_.now = swarm.rest.start;
    if (swarm.rest.restitution.any_below_one()) run_.watch.reset(swarm.size());
    enter(std::move(swarm));
  }

  template <class Sink>
  Stop advance(const Time<double>& until, std::int64_t collisions, Sink&& sink, const std::atomic<bool>* interrupt) {
    const std::int64_t had = counts().collisions();
    const std::int64_t goal =
        collisions < std::numeric_limits<std::int64_t>::max() - had ? had + collisions : std::numeric_limits<std::int64_t>::max();
    if constexpr (std::remove_cvref_t<Sink>::wants_records) {
      run_.sink = [](void* to, const Record<double, D>& record) {
        auto& wanting = *static_cast<std::remove_reference_t<Sink>*>(to);
        wanting(record);
        if constexpr (requires { wanting.moved(std::span<const std::uint32_t>()); }) {
          const std::uint32_t moved[] = {record.ball.number, record.partner.number};
          wanting.moved(std::span(moved).first(record.kind == EventKind::ball_ball ? 2 : 1));
        }
      };
      run_.sink_data = const_cast<void*>(static_cast<const void*>(&sink));
    } else {
      run_.sink = nullptr;
    }
    while (true) {
      if (whole_) {
        const std::int64_t left = goal - counts().collisions();
        const Stop stop = whole_->engine.advance(until, std::min(left, patience()), sink, interrupt);
        if (stop != Stop::events || left <= patience()) return stop;
        if (may_return()) take_back();
        continue;
      }
      switch (kernel_.advance(run_, until, std::min(goal, next_sort_), interrupt)) {
        case Halt::until: return Stop::until;
        case Halt::events:
          if (counts().collisions() >= goal) return Stop::events;
          sort_anew();
          break;
        case Halt::idle: return Stop::no_events_left;
        case Halt::interrupted: return Stop::interrupted;
        case Halt::collapse: return Stop::collapse;
        case Halt::non_finite: run_.reason = "a velocity is no longer a finite number"; return Stop::non_finite;
        case Halt::unusual: hand_over(); break;
      }
    }
  }

  void reverse(const Time<double>& t) {
    if (!whole_) hand_over();
    whole_->engine.reverse(t);
  }
  [[nodiscard]] const Time<double>& now() const { return whole_ ? whole_->engine.now() : run_.now; }
  [[nodiscard]] SwarmView<D> world() const {
    return whole_ ? SwarmView<D>(nullptr, whole_->world) : SwarmView<D>(&run_.swarm, run_.swarm.rest);
  }
  [[nodiscard]] World<double, D> copy() const { return whole_ ? whole_->world : make_world(run_.swarm); }

  /// The counts, books and watch of the run, by whichever of the two.
  struct Accounts {
    const EventCounts& counts;
    const Exactness<double>& exactness;
    const EnergyBooks<double>& books;
    const CollapseWatch<double>& watch;
  };
  [[nodiscard]] Accounts ledger() const {
    if (!whole_) return {run_.counts, run_.exactness, run_.books, run_.watch};
    const Ledger& collider = whole_->engine.collider();
    return {collider.counts, collider.exactness, collider.books, collider.watch};
  }
  [[nodiscard]] StopDetail reason() const {
    if (!whole_) return {run_.reason, run_.reason_balls, {}};
    return {whole_->engine.collider().reason, whole_->engine.collider().reason_balls, {}};
  }

  /// Takes the balls of a saved state one by one: see Integrator. What was there before is let go first.
  class BallByBall {
   public:
    explicit BallByBall(SwarmIntegrator& to) : to_(to) {}
    void judge(const Ball<double, D>& ball, const BallDetail<double, D>& detail) { judge_.add(ball, detail); }
    void begin() {
      const std::size_t size = to_.world().balls.size();
      World<double, D> rest = to_.let_go(names_);
      if (judge_.fit()) {
        maker_.emplace(std::move(rest), size);
      } else {
        world_ = std::move(rest);
        world_.balls.reserve(size);
        world_.details.reserve(size);
      }
    }
    void take(std::uint32_t number, const Ball<double, D>& ball, BallDetail<double, D> detail) {
      if (!names_.empty()) detail.name = std::move(names_[number]);
      if (maker_) return maker_->add(number, ball, detail);
      world_.balls.push_back(ball);
      world_.details.push_back(std::move(detail));
    }
    void finish(Ledger&& ledger, const Time<double>& now) {
      to_.take_accounts(ledger);
      to_.run_.now = now;
      if (maker_) return to_.enter(maker_->finish());
      to_.become_whole(std::move(world_));
    }

   private:
    SwarmIntegrator& to_;
    SwarmJudge<D> judge_;
    std::optional<SwarmMaker<D>> maker_;
    World<double, D> world_;
    std::vector<std::string> names_;
  };

  [[nodiscard]] const SwarmWork& work() const { return run_.work; }

 private:
  struct Whole {
    World<double, D> world;
    EventDriven<Motion, CellGrid<double, D>, HeapQueue<double, D>> engine;

    explicit Whole(World<double, D>&& w) : world(std::move(w)), engine(world, Motion{}) {}
  };

  [[nodiscard]] const EventCounts& counts() const { return whole_ ? whole_->engine.collider().counts : run_.counts; }

  /// Collisions that EventDriven carries out before it is asked whether things have become usual again.
  [[nodiscard]] std::int64_t patience() const { return 64 + static_cast<std::int64_t>(whole_->world.balls.size()) / 8; }

  /// To go over costs some looks at every ball, so it must not be done often: once in as many collisions as there are balls.
  [[nodiscard]] bool may_return() const {
    return (handed_over_ < 8 ||
            handed_over_ * static_cast<std::int64_t>(whole_->world.balls.size()) < counts().collisions()) &&
           is_swarm(whole_->world);
  }

  /// As a swarm, if there is room for its shells; else as a whole world.
  void enter(Swarm<D>&& swarm) {
    run_.swarm = std::move(swarm);
    const BallSizes sizes = sizes_of(run_.swarm);
    thickness_ = shell_thickness<D>(frame_of(run_.swarm.rest), sizes, setup_.neighbours);
    run_.plain = !run_.swarm.rest.restitution.any_below_one() &&
                 std::none_of(run_.swarm.species.begin(), run_.swarm.species.end(),
                              [](const Species& s) { return detail::infinite(s.mass); });
    if (const Species& kind = run_.swarm.species[0]; run_.swarm.species.size() == 1 && run_.plain)
      run_.pair = elastic_pair(2 * kind.radius, kind.mass, kind.mass, 0);
    sort_rows(run_.swarm, run_.now);
    const std::uint32_t n = run_.swarm.size();
    if (!lay_out_shells()) {
      become_whole(make_world(run_.swarm));
      return;
    }
    run_.reach = 2 * sizes.largest + 2 * thickness_;
    run_.per_bucket = n < 5000 ? 18 : n < 50000 ? 32 : 256;
    run_.far_sighted = n > 3000;
    const auto& walls = run_.swarm.rest.walls;
    run_.pieces = numbered_pieces(walls);
    run_.near_walls = PageArray<std::uint8_t>(run_.pieces > walls.faces.size() ? n : 0);
    expect_sort();
    kernel_ = swarm_kernel(run_.swarm, setup_.vectors);
    kernel_.start(run_);
  }

  /// Balls wander off from those that they lie beside in memory: now and then their rows are put in order again, once in
  /// 2000 collisions of a ball (papers/speed).
  void sort_anew() {
    forget_lists();  // first: sorting takes memory too
    sort_rows(run_.swarm, run_.now);
    (void)lay_out_shells();  // as before, and so they fit
    expect_sort();
    kernel_.start(run_);
  }
  [[nodiscard]] bool lay_out_shells() {
    return run_.swarm.species.size() == 1 ? run_.shells.lay_out(run_.swarm, thickness_)
                                          : run_.shells.lay_out(run_.swarm, shells_of(run_.swarm, thickness_));
  }
  void expect_sort() {
    next_sort_ = counts().collisions() + 1000 * static_cast<std::int64_t>(run_.swarm.size());
  }

  void hand_over() {
    ++handed_over_;
    become_whole(make_world(run_.swarm));
  }
  /// The world without its balls, when nothing is kept of them but their names.
  [[nodiscard]] World<double, D> let_go(std::vector<std::string>& names) {
    World<double, D> rest;
    if (whole_) {
      for (auto& detail : whole_->world.details) names.push_back(std::move(detail.name));
      rest = std::move(whole_->world);
      give_back(rest.balls);
      give_back(rest.details);
    } else {
      names = std::move(run_.swarm.names);
      rest = std::move(run_.swarm.rest);
    }
    whole_.reset();
    forget_swarm();
    return rest;
  }
  void forget_swarm() {
    run_.swarm = Swarm<D>();
    forget_lists();
  }
  void forget_lists() {
    run_.shells = Shells<D>();
    run_.calendar = Calendar();
    run_.agenda = PageArray<Due>();
    run_.drained = PageArray<Due>();
    run_.bins = PageArray<std::uint8_t>();
    run_.head = 0;
  }
  void become_whole(World<double, D>&& world) {
    forget_swarm();
    whole_ = std::make_unique<Whole>(std::move(world));
    Ledger& ledger = whole_->engine.collider();
    ledger.counts = run_.counts;
    ledger.exactness = run_.exactness;
    ledger.books = run_.books;
    ledger.watch = run_.watch;
    whole_->engine.resume(run_.now);
  }
  void take_accounts(const Ledger& ledger) {
    run_.counts = ledger.counts;
    run_.exactness = ledger.exactness;
    run_.books = ledger.books;
    run_.watch = ledger.watch;
  }
  void take_back() {
    take_accounts(whole_->engine.collider());
    run_.now = whole_->engine.now();
    World<double, D> world = std::move(whole_->world);
    whole_.reset();
    enter(make_swarm(std::move(world)));
  }

  SwarmSetup setup_;
  SwarmRun<D> run_;
  SwarmKernel<D> kernel_{};
  std::unique_ptr<Whole> whole_;
  std::int64_t handed_over_ = 0;
  double thickness_ = 0;  ///< [length unit] of the shells
  std::int64_t next_sort_ = 0;  ///< collisions after which the rows are put in order again
};

}  // namespace carom
