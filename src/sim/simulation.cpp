#include "carom/sim/simulation.hpp"

#include <algorithm>
#include <cstring>

#include "carom/core/error.hpp"
#include "carom/scene/tables.hpp"
#include "engine.hpp"

namespace carom {

std::string Composition::text() const { return motion + ", " + search + ", " + queue; }

Glimpse Simulation::Engine::glimpse(std::uint32_t number) const {
  const BallState state = ball(number);
  Glimpse g;
  std::copy(state.unwrapped_position.begin(), state.unwrapped_position.end(), g.position.begin());
  std::copy(state.velocity.begin(), state.velocity.end(), g.velocity.begin());
  g.radius = state.radius;
  g.mass = state.mass;
  return g;
}

namespace {
template <int D>
std::unique_ptr<Simulation::Engine> compose_in(const Scene& scene, const Precision& precision) {
  return precision.is_double() ? make_engine<D>(scene) : make_precise_engine<D>(scene, precision);
}

std::unique_ptr<Simulation::Engine> compose(const Scene& scene, const Precision& precision) {
  switch (scene.dimension) {
    case 1:
      return compose_in<1>(scene, precision);
    case 2:
      return compose_in<2>(scene, precision);
    case 3:
      return compose_in<3>(scene, precision);
    default:
      throw InputError(Problem{scene.file, 0, "dimension = " + std::to_string(scene.dimension), "it is 1, 2 or 3", ""});
  }
}

std::unique_ptr<Simulation::Engine> compose_reference(const Scene& scene) {
  switch (scene.dimension) {
    case 1:
      return make_reference_engine<1>(scene);
    case 2:
      return make_reference_engine<2>(scene);
    default:
      return make_reference_engine<3>(scene);
  }
}
}  // namespace

Simulation::Simulation(const Scene& scene, const Precision& precision)
    : engine_(has_tables_out(scene) ? compose(with_tables(scene), precision) : compose(scene, precision)) {}
Simulation::Simulation(std::unique_ptr<Engine> engine) : engine_(std::move(engine)) {}
Simulation Simulation::reference(const Scene& scene) {
  return Simulation(compose_reference(has_tables_out(scene) ? with_tables(scene) : scene));
}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

Stop Simulation::run(const CollisionSink& sink) { return advance(engine_->until, engine_->events, sink); }

Stop Simulation::advance(const std::optional<Number>& until, std::optional<std::int64_t> events, const CollisionSink& sink,
                         const std::atomic<bool>* interrupt) {
  return engine_->advance(until, events, sink, interrupt);
}

void Simulation::watch_motion(MotionSink sink) { engine_->motion_sink = std::move(sink); }
void Simulation::reverse() { engine_->reverse(); }
Number Simulation::time() const { return engine_->time(); }
Summary Simulation::summary() const { return engine_->summary(); }
const EventCounts& Simulation::counts() const { return engine_->counts(); }
std::optional<std::int64_t> Simulation::predictions() const { return engine_->predictions(); }
BallState Simulation::ball(std::uint32_t number) const { return engine_->ball(number); }

std::vector<BallState> Simulation::balls() const {
  std::vector<BallState> left;
  for (std::uint32_t i = 0; i < engine_->ball_count(); ++i)
    if (engine_->alive(i)) left.push_back(engine_->ball(i));
  return left;
}

std::uint32_t Simulation::ball_count() const { return engine_->ball_count(); }
bool Simulation::alive(std::uint32_t number) const { return engine_->alive(number); }
Glimpse Simulation::glimpse(std::uint32_t number) const { return engine_->glimpse(number); }
void Simulation::return_to_last_event() { engine_->return_to_last_event(); }
std::vector<Departure> Simulation::departures() const {
  std::vector<Departure> all = engine_->departures();
  std::stable_sort(all.begin(), all.end(), [](const Departure& a, const Departure& b) { return a.time < b.time; });
  return all;
}
double Simulation::radius_growth(std::uint32_t number) const { return engine_->radius_growth(number); }
std::uint32_t Simulation::wall_count() const { return engine_->wall_count(); }
std::string Simulation::wall_label(std::uint32_t wall) const { return engine_->wall_label(wall); }
std::array<double, 3> Simulation::periods() const { return engine_->periods(); }
int Simulation::dimension() const { return engine_->dimension; }
double Simulation::epoch_length() const { return engine_->units().epoch_length(); }
const Composition& Simulation::composition() const { return engine_->composition(); }
Audit Simulation::audit(AuditBy by) const { return engine_->audit(by); }

std::string Simulation::state() const {
  std::string bytes;
  save([&bytes](std::string_view piece) { bytes += piece; });
  return bytes;
}
void Simulation::save(const std::function<void(std::string_view)>& piece) const { engine_->save(piece); }
void Simulation::restore(std::string_view state) {
  restore(state.size(), [state](std::uint64_t at, std::span<char> to) { std::memcpy(to.data(), state.data() + at, to.size()); });
}
void Simulation::restore(std::uint64_t size, const std::function<void(std::uint64_t, std::span<char>)>& read) {
  engine_->restore(size, read);
}

}  // namespace carom
