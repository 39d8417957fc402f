#include "carom/observe/samplers.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "carom/observe/enskog.hpp"
#include "judgement.hpp"

namespace carom {

namespace {

// Default distances of samples, in mean free times: pairs forget where they were in tens of them, velocities in one or two;
// displacements are those of diffusion after tens.
constexpr double between_pairs = 10, between_displacements = 1, between_velocities = 0.2;

/// The radius of all balls that move freely, if they are equal in radius and mass; else 0.
double common_radius(const Subject& s) {
  double radius = 0, mass = 0;
  for (std::uint32_t i = 0; i < s.mass.size(); ++i) {
    if (!s.moves_freely(i)) continue;
    if (mass > 0 && (s.radius[i] != radius || s.mass[i] != mass)) return 0;
    radius = s.radius[i];
    mass = s.mass[i];
  }
  return radius;
}

double mean_radius(const Subject& s) {
  double sum = 0;
  for (std::uint32_t i = 0; i < s.mass.size(); ++i) sum += s.moves_freely(i) ? s.radius[i] : 0.0;
  return sum / static_cast<double>(s.free);
}

double shortest_period(const Subject& s) {
  return *std::min_element(s.edge.begin(), s.edge.begin() + s.dimension);
}

/// From what the scene asks for to what is measured.
class Settling {
 public:
  Settling(const Scene& scene, const Simulation& simulation)
      : subject_(subject_of(scene, simulation)), merging_(scene.collision.law == LawKind::merge), judgement(scene) {
    free_time_ = enskog_free_time(subject_);
    restitution_ = scene.collision.law == LawKind::restitution;
    if (subject_.free < 1) judgement.refuse("*", "no ball has a finite mass", "Add a ball that is not fixed");
  }

  double every(const char* key, const std::optional<Number>& given, double free_times) {
    if (merging_)
      judgement.refuse(key, "balls that merge are fewer and fewer", "Only collision_rate is measured with law \"merge\"");
    if (given) return *given;
    if (!std::isfinite(free_time_))
      judgement.add(std::string("observe.") + key + " needs \"every\"",
                    "nothing says how long the balls of this scene fly freely",
                    std::string("Give ") + key + " = { every = 0.1 }");
    return free_time_ * free_times;
  }

  RadialDistribution::Settings radial(const RadialDistributionSpec& spec) {
    RadialDistribution::Settings s;
    s.dimension = subject_.dimension;
    s.edge = subject_.edge;
    s.bins = static_cast<std::size_t>(spec.bins);
    const double half = shortest_period(subject_) / 2;
    s.r_max = spec.r_max ? spec.r_max->value : half;
    if (!spec.r_max && mean_radius(subject_) > 0) s.r_max = std::min(half, 8 * mean_radius(subject_));
    if (subject_.space != SpaceKind::periodic) {
      judgement.refuse("radial_distribution", "near walls balls lie otherwise than among themselves",
                       "Give [space] kind \"periodic\"");
    } else if (s.r_max > half) {
      judgement.add("observe.radial_distribution.r_max is " + std::to_string(s.r_max),
                    "beyond half of the shortest period a ball would be counted with its images",
                    "At most " + std::to_string(half));
    }
    if (restitution_ && subject_.free > 1 && !subject_.has_obstacles()) s.diameter = 2 * common_radius(subject_);
    if (2 * common_radius(subject_) * 1.1 > s.r_max) s.diameter = 0;
    for (const double m : subject_.mass) s.mass = std::max(s.mass, std::isfinite(m) ? m : 0.0);
    return s;
  }

  std::size_t origins(const LagsSpec& spec) const {
    const auto most = static_cast<std::size_t>(spec.lags) + 1;
    return std::min(most, spec.origins ? static_cast<std::size_t>(*spec.origins)
                                       : usual_origins(static_cast<std::size_t>(subject_.free)));
  }

 private:
  Subject subject_;
  bool merging_, restitution_ = true;
  double free_time_ = 0;

 public:
  ObserveJudgement judgement;
};

}  // namespace

Samplers::Samplers(const Scene& scene, const Simulation& simulation) : after_events_(scene.observe.after_events) {
  const ObserveSpec& asked = scene.observe;
  after_ = simulation.time();
  if (asked.after_time) after_ = std::max(after_, asked.after_time->value);
  if (observed_tables(asked).empty()) return;
  Settling settle(scene, simulation);
  const int d = scene.dimension;
  if (const auto& r = asked.radial_distribution) {
    const double every = settle.every("radial_distribution", r->every, between_pairs);
    const RadialDistribution::Settings settings = settle.radial(*r);
    samplers_.push_back({RadialDistribution(settings), every});
  }
  if (const auto& m = asked.mean_squared_displacement) {
    const double every = settle.every("mean_squared_displacement", m->every, between_displacements);
    const auto lags = static_cast<std::size_t>(m->lags);
    samplers_.push_back({MeanSquaredDisplacement(d, lags, settle.origins(*m), every), every});
  }
  if (const auto& v = asked.velocity_autocorrelation) {
    const double every = settle.every("velocity_autocorrelation", v->every, between_velocities);
    const auto lags = static_cast<std::size_t>(v->lags);
    samplers_.push_back({VelocityAutocorrelation(d, lags, settle.origins(*v), every), every});
  }
  if (const auto& a = asked.angle_autocorrelation) {
    const double every = settle.every("angle_autocorrelation", a->every, between_velocities);
    const auto lags = static_cast<std::size_t>(a->lags);
    samplers_.push_back({AngleAutocorrelation(lags, settle.origins(*a), every), every});
  }
  if (const auto& m = asked.diffusion) {
    const double every = settle.every("diffusion", m->every, between_displacements);
    const auto lags = static_cast<std::size_t>(m->lags);
    const auto named = MeanSquaredDisplacement::Named::diffusion;
    samplers_.push_back({MeanSquaredDisplacement(d, lags, settle.origins(*m), every, named), every});
  }
  settle.judgement.throw_if_any();
}

std::optional<Appointment> Samplers::next() const {
  if (!any()) return std::nullopt;
  if (!began_) return after_events_ ? Appointment{std::nullopt, after_events_} : Appointment{Number(after_), std::nullopt};
  return Appointment{Number(first_due()), std::nullopt};
}

double Samplers::first_due() const {
  double first = HUGE_VAL;
  for (const Timed& t : samplers_) first = std::min(first, due(t));
  return first;
}

void Samplers::look(const Simulation& simulation) {
  if (!began_) began_ = simulation.time();
  look_at(simulation, balls_);
  const double now = first_due();  // the clock has rounded it
  for (Timed& t : samplers_) {
    if (due(t) > now) continue;
    std::visit([this](auto& s) { s.sample(balls_); }, t.sampler);
    ++t.taken;
  }
}

Stop run_sampled(Simulation& simulation, const RunSpec& run, Samplers& samplers, const CollisionSink& sink) {
  while (true) {
    const std::optional<Appointment> next = samplers.next();
    const bool in_time = next && next->time && (!run.until || next->time->value <= run.until->value);
    std::int64_t last = run.events.value_or(std::numeric_limits<std::int64_t>::max());
    if (next && next->events) last = std::min(last, std::max(*next->events, simulation.counts().collisions()));
    const Stop stop = simulation.advance(in_time ? next->time : run.until, last - simulation.counts().collisions(), sink);
    const bool in_peace = stop == Stop::until || (stop == Stop::no_events_left && run.until);
    const bool reached =
        next && (next->events ? simulation.counts().collisions() >= *next->events : in_time && in_peace);
    if (reached) {
      samplers.look(simulation);
    } else {
      if (stop == Stop::no_events_left && in_time) simulation.return_to_last_event();
      return stop;
    }
    if (run.events && simulation.counts().collisions() >= *run.events) return Stop::events;
  }
}

Estimates Samplers::estimates() const {
  Estimates all;
  for (const Timed& t : samplers_) {
    Estimates some = std::visit([](const auto& s) { return s.estimates(); }, t.sampler);
    std::move(some.begin(), some.end(), std::back_inserter(all));
  }
  return all;
}

std::vector<Table> Samplers::tables() const {
  std::vector<Table> all;
  for (const Timed& t : samplers_) all.push_back(std::visit([](const auto& s) { return s.table(); }, t.sampler));
  return all;
}

std::vector<std::string> observed_tables(const ObserveSpec& observe) {
  std::vector<std::string> names;
  if (observe.radial_distribution) names.emplace_back("radial_distribution");
  if (observe.mean_squared_displacement) names.emplace_back("mean_squared_displacement");
  if (observe.velocity_autocorrelation) names.emplace_back("velocity_autocorrelation");
  if (observe.angle_autocorrelation) names.emplace_back("angle_autocorrelation");
  if (observe.diffusion) names.emplace_back("diffusion");
  return names;
}

}  // namespace carom
