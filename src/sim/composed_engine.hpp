#pragma once
// An integrator with its world, and the translation of its results into the user's units.

#include <algorithm>
#include <cmath>
#include <span>

#include "carom/core/error.hpp"
#include "carom/core/multi.hpp"
#include "carom/sim/event_driven.hpp"
#include "carom/sim/totals.hpp"
#include "carom/world/build.hpp"
#include "carom/world/placement/radius.hpp"
#include "engine.hpp"
#include "quantity.hpp"
#include "state_bytes.hpp"

namespace carom {

/// What ComposedEngine asks of an integrator: it owns a world, in whatever form, and moves it. `world` is that, or a view with
/// its members; `ledger` has counts, exactness, books and watch; `reason` says why the run stopped. One with a BallByBall
/// takes the balls of a saved state by that: all are judged, and then, between `begin` and `finish`, taken in turn.
template <class I>
concept Integrator = requires(I& i, const I& c, const Time<typename I::Motion::Real>& t) {
  typename I::Motion;
  c.world();
  c.ledger();
  {c.now()};
  {c.reason()};
  {i.reverse(t)};
  {i.copy()};
};

/// EventDriven and the world that it moves.
template <Motion M, class Search, class Queue>
class WorldIntegrator {
 public:
  using Motion = M;
  using Real = typename M::Real;
  static constexpr int D = M::dimension;

  WorldIntegrator(World<Real, D>&& world, const M& motion, Search search)
      : world_(std::move(world)), engine_(world_, motion, std::move(search)) {}
  WorldIntegrator(const WorldIntegrator&) = delete;
  WorldIntegrator& operator=(const WorldIntegrator&) = delete;

  template <class Sink>
  Stop advance(const Time<Real>& until, std::int64_t collisions, Sink&& sink, const std::atomic<bool>* interrupt) {
    return engine_.advance(until, collisions, sink, interrupt);
  }
  void reverse(const Time<Real>& t) { engine_.reverse(t); }
  [[nodiscard]] const Time<Real>& now() const { return engine_.now(); }
  [[nodiscard]] const World<Real, D>& world() const { return world_; }
  [[nodiscard]] World<Real, D> copy() const { return world_; }
  [[nodiscard]] const Collider<M>& ledger() const { return engine_.collider(); }
  [[nodiscard]] StopDetail reason() const { return {engine_.collider().reason, engine_.collider().reason_balls, {}}; }
  void restore(World<Real, D>&& world, Collider<M>&& ledger, const Time<Real>& now) {
    world_ = std::move(world);
    engine_.collider() = std::move(ledger);
    engine_.resume(now);
  }

 private:
  World<Real, D> world_;
  EventDriven<M, Search, Queue> engine_;
};

/// What ComposedEngine reads of the world that it is made with.
template <class Real, int D>
[[nodiscard]] const World<Real, D>& as_world(const World<Real, D>& world) {
  return world;
}

template <Integrator I>
class ComposedEngine final : public Simulation::Engine {
 public:
  using M = typename I::Motion;
  using Real = typename M::Real;
  static constexpr int D = M::dimension;

  /// Made within a PrecisionScope<Real> of `precision`, as every method enters it. `begin` is a world, or what the integrator
  /// takes in its place and `as_world` looks at; `setup` is what it takes beside that and a motion.
  template <class Begin, class Setup>
  ComposedEngine(const Scene& scene, Begin begin, const M& motion, Composition composition, Setup setup,
                 const Precision& precision = {})
      : Engine(scene, std::move(composition)), precision_(precision), motion_(motion) {
    take_start(as_world(begin));
    integrator_.emplace(std::move(begin), motion, std::move(setup));
  }

  Stop advance(const std::optional<Number>& to, std::optional<std::int64_t> most, const CollisionSink& sink,
               const std::atomic<bool>* interrupt) override {
    const Scope scope(precision_.digits);
    Time<Real> end = to ? clock_time<Real>(*to, world().units.time) : Time<Real>::never();
    if (end < reached_) end = reached_;
    const std::int64_t collisions = most.value_or(std::numeric_limits<std::int64_t>::max());
    stop_ = sink || motion_sink ? integrator_->advance(end, collisions, Translate{*this, sink}, interrupt)
                                : integrator_->advance(end, collisions, NoSink{}, interrupt);
    const bool to_the_end = (stop_ == Stop::until || stop_ == Stop::no_events_left) && !end.is_never();
    if (to_the_end) {
      reached_ = end;
    } else if (stop_ == Stop::packing) {
      if constexpr (GrowingMotion<M>) reached_ = world().growth.packed;
    } else if (integrator_->now() > reached_) {
      reached_ = integrator_->now();
    }
    return stop_;
  }

  [[nodiscard]] std::optional<std::int64_t> predictions() const override {
    if constexpr (requires { integrator_->work().predictions; }) return integrator_->work().predictions;
    return std::nullopt;
  }

  void return_to_last_event() override {
    const Scope scope(precision_.digits);
    reached_ = integrator_->now();
  }
  void reverse() override {
    const Scope scope(precision_.digits);
    integrator_->reverse(reached_);
    if constexpr (M::circular) motion_.reverse();
  }

  [[nodiscard]] Number time() const override {
    const Scope scope(precision_.digits);
    return in_users_time(reached_);
  }
  [[nodiscard]] const EventCounts& counts() const override { return integrator_->ledger().counts; }
  [[nodiscard]] std::uint32_t ball_count() const override { return static_cast<std::uint32_t>(world().balls.size()); }
  [[nodiscard]] bool alive(std::uint32_t i) const override { return world().balls.at(i).alive; }
  [[nodiscard]] std::vector<Departure> departures() const override {
    const Scope scope(precision_.digits);
    std::vector<Departure> all;
    if (world().walls.openings.empty()) return all;
    for (std::uint32_t i = 0; i < world().balls.size(); ++i) {
      const Ball<Real, D> ball = world().balls[i];
      const BallDetail<Real, D> detail = world().details[i];
      if (ball.alive || detail.last_party != Party::wall || !world().walls.opens(detail.last_partner)) continue;
      Departure& d = all.emplace_back();
      d.ball = i;
      d.time = nearest_time(ball.time);
      d.wall = detail.last_partner;
      d.feature = detail.last_feature;
      const auto far = unwrapped(world(), i, ball.position);
      for (int k = 0; k < D; ++k) {
        d.position[k] = near(narrow(far[k]), world().units.length);
        d.velocity[k] = near(ball.velocity[k], world().units.velocity());
      }
    }
    return all;
  }
  [[nodiscard]] double radius_growth(std::uint32_t i) const override {
    return near(growth_of(world(), i), world().units.velocity());
  }
  [[nodiscard]] std::uint32_t wall_count() const override { return static_cast<std::uint32_t>(world().walls.labels.size()); }
  [[nodiscard]] std::string wall_label(std::uint32_t wall) const override { return world().walls.labels.at(wall); }
  [[nodiscard]] Units units() const override { return world().units; }
  [[nodiscard]] std::array<double, 3> periods() const override {
    std::array<double, 3> edge{};
    for (int k = 0; k < D && world().space.periodic(); ++k) edge[k] = near(world().space.edge[k], world().units.length);
    return edge;
  }

  [[nodiscard]] BallState ball(std::uint32_t i) const override {
    const Scope scope(precision_.digits);
    BallState state;
    state.index = i;
    state.name = world().details.at(i).name;
    Vec<Real, D> x = position_at(motion_, world(), i, reached_);
    const Vec<Real, D> v = velocity_at(motion_, world(), i, reached_);
    const auto far = unwrapped(world(), i, x);
    const auto turns = wrap(world().space, x);
    for (int k = 0; k < D; ++k) {
      state.position.push_back(user(x[k], world().units.length));
      state.image.push_back(world().details[i].image[k] + turns[k]);
      state.unwrapped_position.push_back(user(narrow(far[k]), world().units.length));
      state.velocity.push_back(user(v[k], world().units.velocity()));
    }
    state.radius = user(radius_at(world(), i, reached_), world().units.length);
    state.mass = user(world().details[i].mass, world().units.mass);
    return state;
  }

  [[nodiscard]] Glimpse glimpse(std::uint32_t i) const override {
    const Scope scope(precision_.digits);
    const Vec<Real, D> x = position_at(motion_, world(), i, reached_);
    const Vec<Real, D> v = velocity_at(motion_, world(), i, reached_);
    const auto far = unwrapped(world(), i, x);
    Glimpse g;
    for (int k = 0; k < D; ++k) {
      g.position[k] = near(narrow(far[k]), world().units.length);
      g.velocity[k] = near(v[k], world().units.velocity());
    }
    g.radius = near(radius_at(world(), i, reached_), world().units.length);
    g.mass = near(world().details[i].mass, world().units.mass);
    return g;
  }

  [[nodiscard]] Audit audit(AuditBy by) const override {
    const Scope scope(precision_.digits);
    Audit result = carom::audit(motion_, world(), reached_, by);
    result.deepest = std::ldexp(result.deepest, world().units.length);
    return result;
  }

  void save(const std::function<void(std::string_view)>& piece) const override {
    const Scope scope(precision_.digits);
    WritingArchive archive{ByteWriter(piece)};
    archive.out.put(checkpoint_magic);
    archive.out.put(checkpoint_version);
    archive.out.put(scene_print_);
    StateVisitor<WritingArchive> visitor(archive);
    visit_course(visitor, integrator_->ledger(), integrator_->now(), reached_);
    decltype(auto) world = this->world();
    visitor.world(world);
    archive.out.put(archive.out.fingerprint());
    archive.out.flush();
  }

  void restore(std::uint64_t size, const ByteSource& read) override {
    const Scope scope(precision_.digits);
    const auto refuse = [](const char* what, const char* hint) { throw InputError(Problem{"", 0, what, "", hint}); };
    constexpr std::size_t print_size = sizeof(std::uint64_t);
    if (size < 4 * print_size) refuse("the checkpoint is too short to be one", "Give a file that carom wrote");
    ByteReader head(read, 0, 3 * print_size);
    if (head.get<std::uint64_t>() != checkpoint_magic)
      refuse("this is no checkpoint of carom", "Give a file that carom wrote");
    if (head.get<std::uint64_t>() != checkpoint_version)
      refuse("the checkpoint is of another version of carom", "Resume it with the version that wrote it");
    if (ByteReader(read, size - print_size, size).get<std::uint64_t>() != fingerprint(read, size - print_size))
      refuse("the checkpoint is damaged", "Use an earlier one");
    if (head.get<std::uint64_t>() != scene_print_)
      refuse("the checkpoint is of another scene", "Resume it with the scene that it was made from");
    try {
      // Until all of it has been read once, nothing is changed.
      ReadingArchive archive{ByteReader(read, 3 * print_size, size - print_size)};
      StateVisitor<ReadingArchive> visitor(archive);
      Collider<M> collider;
      Time<Real> now, reached;
      visit_course(visitor, collider, now, reached);
      const auto end = [&archive] {
        if (!archive.in.at_end()) throw std::out_of_range("bytes left over");
      };
      if constexpr (requires { typename I::BallByBall; }) {
        const ByteReader first_ball = archive.in;
        const auto read_balls = [&, balls = ball_count()](auto&& f) {
          archive.in = first_ball;
          visitor.template read_balls<Real, D>(balls, f);
        };
        typename I::BallByBall taker(*integrator_);
        read_balls([&taker](std::uint32_t, const Ball<Real, D>& b, const BallDetail<Real, D>& d) { taker.judge(b, d); });
        World<Real, D> none;
        visitor.bodies(none);
        end();
        taker.begin();
        read_balls([&taker](std::uint32_t i, const Ball<Real, D>& b, const BallDetail<Real, D>& d) { taker.take(i, b, d); });
        taker.finish(std::move(collider), now);
      } else {
        World<Real, D> world = integrator_->copy();
        visitor.world(world);
        end();
        integrator_->restore(std::move(world), std::move(collider), now);
      }
      reached_ = reached;
    } catch (const std::out_of_range&) {
      refuse("the checkpoint is damaged", "Use an earlier one");
    }
  }

  [[nodiscard]] Summary summary() const override {
    const Scope scope(precision_.digits);
    Summary s;
    s.title = title;
    s.dimension = D;
    s.balls = ball_count();
    s.composition = composition().text();
    s.precision = precision_.text();
    s.seed = seed;
    s.epoch_length = world().units.epoch_length();
    s.time = in_users_time(reached_);
    s.stopped_by = stop_;
    if (stop_ == Stop::collapse || stop_ == Stop::non_finite)
      s.stopped = StopDetail{integrator_->reason().reason, integrator_->reason().balls, in_users_time(integrator_->now())};
    s.events = counts();
    const Totals<Real, D> now = totals_at(motion_, world(), reached_);
    s.energy = energy(now);
    s.momentum = momentum(now);
    s.angular_momentum = angular_momentum(now);
    const Exactness<Real>& e = integrator_->ledger().exactness;
    s.exactness = {user(e.max_gap_error, world().units.length),
                   user(e.max_gap_error_relative, 0),
                   e.clamped,
                   e.unresolved,
                   e.singular,
                   e.summed_bounces,
                   e.repredicted};
    if constexpr (GrowingMotion<M>) s.growth = growth();
    return s;
  }

 private:
  using W = Wide<Real>;
  using Scope = PrecisionScope<Real>;
  static constexpr std::uint64_t checkpoint_magic = 0x6d6f726163636863;  // "chccarom"
  static constexpr std::uint64_t checkpoint_version = 3;

  [[nodiscard]] static std::uint64_t fingerprint(const ByteSource& read, std::uint64_t size) {
    Fingerprint print;
    std::vector<char> piece;
    for (std::uint64_t at = 0; at < size; at += piece.size()) {
      piece.resize(static_cast<std::size_t>(std::min<std::uint64_t>(piece_size, size - at)));
      read(at, piece);
      print.add({piece.data(), piece.size()});
    }
    return print.value();
  }

  /// All of a state but the world. Writes what is constant, reads into what is not.
  static void visit_course(auto& visitor, auto&& collider, auto& now, auto& reached) {
    visitor.time(now);
    visitor.time(reached);
    visitor.counts(collider.counts);
    visitor.exactness(collider.exactness);
    visitor.books(collider.books);
    visitor.watch(collider.watch);
    if constexpr (GrowingMotion<M>) visitor.growth(collider.growth);
  }

  /// What is kept of the start. `world` may be a view.
  void take_start(const auto& world) {
    reached_ = world.start;
    start_ = totals_at(motion_, world, world.start);
    conserved_momentum_ = start_.all_finite && world.walls.empty() && !world.curved() && world.growth.rescale_every == 0;
    scene_print_ = print_of_scene(world);
  }

  /// Of all that the scene decides: the balls at the start, the walls, the laws and the space.
  [[nodiscard]] static std::uint64_t print_of_scene(const auto& world) {
    WritingArchive archive{ByteWriter()};
    StateVisitor<WritingArchive>(archive).world(world);
    archive(D);
    archive(world.units.length);
    archive(world.units.time);
    archive(world.units.mass);
    archive(world.start.epoch);
    archive(world.start.offset);
    archive(world.law);
    archive(world.simultaneous);
    archive(world.regularise);
    archive(world.contact_time);
    archive(world.reference_speed);
    archive(world.magnetic);
    archive(world.space.kind);
    for (int k = 0; k < D; ++k) {
      archive(world.space.lower[k]);
      archive(world.space.edge[k]);
      archive(world.acceleration[k]);
    }
    for (const Real& e : world.restitution.values()) archive(e);
    for (const bool opening : world.walls.openings) archive(opening);
    for (const Real& rate : world.growth.rates) archive(rate);
    if (world.growth.any()) archive(world.growth.rescale_every);
    world.walls.for_each([&](const auto& shape) {
      archive(index(shape.wall));
      archive(shape.feature);
      // Where it stands, seen from the corners of a simplex: no two shapes of a kind look alike from all of them.
      Vec<Real, D> from = Vec<Real, D>::Zero();
      for (int k = -1; k < D; ++k) {
        if (k >= 0) from[k] = Real(1);
        archive(shape.gap(from));
      }
      if constexpr (requires { shape.velocity; })
        for (int k = 0; k < D; ++k) archive(shape.velocity[k]);
      if (const Swing<Real, D>* swing = swing_of(world.walls, shape)) {
        for (int k = 0; k < D; ++k) archive(swing->amplitude[k]);
        archive(swing->omega);
        archive(swing->phase);
      }
    });
    return archive.out.fingerprint();
  }

  /// The nearest double, in the user's unit.
  [[nodiscard]] static double near(const Real& x, int exponent) { return scaled(static_cast<double>(x), exponent); }
  [[nodiscard]] double nearest_time(const Time<Real>& t) const {
    return near(narrow(W(W(Real(t.epoch)) + W(t.offset))), world().units.time);
  }
  [[nodiscard]] static Number user(const Real& x, int exponent) { return quantity(x, exponent); }
  [[nodiscard]] Number in_users_time(const Time<Real>& t) const {
    return user(narrow(W(W(Real(t.epoch)) + W(t.offset))), world().units.time);
  }

  // 0/0 is 0; a nonzero error of nothing is infinite, and says so.
  [[nodiscard]] static Number ratio(const Real& error, const Real& size) {
    using std::abs;
    const Real e = abs(error);
    return e == 0 ? Number(0.0) : quantity(Real(e / size), 0);
  }

  [[nodiscard]] EnergyBalance energy(const Totals<Real, D>& now) const {
    const EnergyBooks<Real>& books = integrator_->ledger().books;
    const W initial = start_.kinetic + start_.potential, final = now.kinetic + now.potential;
    W injected = books.injected;
    if constexpr (M::can_rest)
      for (std::uint32_t i = 0; i < world().balls.size(); ++i) injected = injected + work_at_rest(world(), i, reached_);
    const Real error = narrow(W((final - initial) + (books.dissipated - injected)));
    // kinetic + potential + dissipated = initial + injected at every moment, so it is largest where injected is. Potential
    // counts from the lowest place that a ball was seen at.
    W lowest(Real(0));
    if (world().accelerated() && start_.mass > W(Real(0)))
      lowest = start_.mass * W(std::min(books.lowest_potential, now.lowest_potential));
    const Real largest = narrow(W(initial - lowest)) + 2 * std::max<Real>(books.largest_injected, narrow(injected));
    const int unit = world().units.energy();
    return {user(narrow(initial), unit), user(narrow(final), unit), user(narrow(books.dissipated), unit),
            user(narrow(injected), unit), ratio(error, largest)};
  }

  template <std::size_t N>
  [[nodiscard]] VectorBalance balance(const std::array<W, N>& before, const std::array<W, N>& after, std::size_t components,
                                      const Real& size, bool conserved, int unit) const {
    using std::sqrt;
    VectorBalance b;
    Real error(0);
    for (std::size_t k = 0; k < components; ++k) {
      b.initial.push_back(user(narrow(before[k]), unit));
      b.final.push_back(user(narrow(after[k]), unit));
      const Real d = narrow(W(after[k] - before[k]));
      error += d * d;
    }
    if (conserved) b.relative_error = ratio(sqrt(error), size);
    return b;
  }
  [[nodiscard]] VectorBalance momentum(const Totals<Real, D>& now) const {
    return balance(start_.momentum, now.momentum, D, start_.momentum_size, conserved_momentum_, world().units.momentum());
  }
  [[nodiscard]] VectorBalance angular_momentum(const Totals<Real, D>& now) const {
    // A ball that starts at the origin has none to compare with; then what it has now.
    const Real size = start_.angular_momentum_size > 0 ? start_.angular_momentum_size : now.angular_momentum_size;
    return balance(start_.angular_momentum, now.angular_momentum, Totals<Real, D>::rotations, size,
                   conserved_momentum_ && D > 1 && !world().space.periodic() && world().law == LawKind::restitution,
                   world().units.angular_momentum());
  }

  [[nodiscard]] GrowthSummary growth() const requires GrowingMotion<M> {
    GrowthSummary g;
    if (integrator_->ledger().growth.pressure > 0) g.reduced_pressure = static_cast<double>(integrator_->ledger().growth.pressure);
    if (world().space.kind == SpaceKind::open) return g;
    double filled = 0, room = 1;
    for (std::uint32_t i = 0; i < world().balls.size(); ++i)
      filled += ball_volume(static_cast<double>(radius_at(world(), i, reached_)), D);
    for (int k = 0; k < D; ++k) room *= static_cast<double>(world().space.edge[k]);
    g.packing_fraction = filled / room;
    return g;
  }

  [[nodiscard]] MotionChange motion_of(std::uint32_t i) const {
    const Ball<Real, D> ball = world().balls[i];
    const Units u = world().units;
    const Vec<Real, D> a = motion_.acceleration(M::phase(ball));
    MotionChange m;
    m.ball = i;
    m.time = nearest_time(ball.time);
    m.epoch = ball.time.epoch;
    m.offset = near(ball.time.offset, u.time);
    for (int k = 0; k < D; ++k) {
      m.position[k] = near(ball.position[k], u.length);
      m.image[k] = world().details[i].image[k];
      m.velocity[k] = near(ball.velocity[k], u.velocity());
      m.acceleration[k] = near(a[k], u.acceleration());
    }
    m.radius = near(radius_at(world(), i, Time<Real>(ball.time)), u.length);
    m.radius_growth = near(growth_of(world(), i), u.velocity());
    m.mass = near(world().details[i].mass, u.mass);
    m.alive = ball.alive;
    return m;
  }

  /// Hands records on as collisions in the user's units.
  struct Translate {
    static constexpr bool wants_records = true;
    const ComposedEngine& engine;
    const CollisionSink& sink;

    void operator()(const Record<Real, D>& r) const {
      const Units u = engine.world().units;
      if (!sink) return;
      Collision c;
      c.time = engine.nearest_time(r.time);
      c.epoch = r.time.epoch;
      c.offset = near(r.time.offset, u.time);
      c.kind = r.kind;
      c.feature = r.feature;
      party(c.ball, r.ball, u);
      party(c.partner, r.partner, u);
      for (int k = 0; k < D; ++k) {
        c.normal[k] = static_cast<double>(r.normal[k]);
        c.point[k] = near(r.point[k], u.length);
      }
      c.impulse = near(r.impulse, u.momentum());
      c.gap = near(r.gap, u.length);
      c.curvature = near(r.curvature, -u.length);
      c.arclength = near(r.arclength, u.length);
      c.restitution = static_cast<double>(r.restitution);
      c.dissipated = near(r.dissipated, u.energy());
      c.injected = near(r.injected, u.energy());
      c.tie = r.tie;
      if constexpr (std::is_same_v<Real, double>) {
        sink(c);
      } else {
        const CollisionDigits digits = digits_of_record(r, u);
        c.digits = &digits;
        sink(c);
      }
    }
    void moved(std::span<const std::uint32_t> balls) const {
      if (!engine.motion_sink) return;
      for (const std::uint32_t i : balls) engine.motion_sink(engine.motion_of(i));
    }
    [[nodiscard]] CollisionDigits digits_of_record(const Record<Real, D>& r, const Units& u) const {
      CollisionDigits d;
      d.time = engine.in_users_time(r.time).text;
      d.offset = user(r.time.offset, u.time).text;
      d.impulse = user(r.impulse, u.momentum()).text;
      for (const auto& [to, from] : {std::pair{&d.ball, &r.ball}, std::pair{&d.partner, &r.partner}})
        for (int k = 0; k < D; ++k) {
          to->position[k] = user(from->position[k], u.length).text;
          to->velocity[k] = user(from->velocity_after[k], u.velocity()).text;
        }
      return d;
    }
    static void party(Collision::Party& to, const RecordParty<Real, D>& from, const Units& u) {
      to.number = from.number;
      for (int k = 0; k < D; ++k) {
        to.position[k] = near(from.position[k], u.length);
        to.image[k] = from.image[k];
        to.velocity_before[k] = near(from.velocity_before[k], u.velocity());
        to.velocity_after[k] = near(from.velocity_after[k], u.velocity());
      }
    }
  };

  [[nodiscard]] decltype(auto) world() const { return integrator_->world(); }

  Precision precision_;
  M motion_;
  Time<Real> reached_;
  Totals<Real, D> start_;
  bool conserved_momentum_ = false;
  std::uint64_t scene_print_ = 0;
  Stop stop_ = Stop::until;
  std::optional<I> integrator_;
};

}  // namespace carom
