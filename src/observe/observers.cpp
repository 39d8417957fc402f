#include "carom/observe/observers.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "judgement.hpp"

namespace carom {

static_assert(Observer<CollisionRate> && Observer<WallPressure> && Observer<VirialPressure>);
static_assert(FlightObserver<FreePath> && FlightObserver<SpeedHistogram>);

namespace {

/// Why the gas has no virial pressure; empty: it has one.
std::string no_virial(const Subject& s) {
  if (s.accelerated()) return "in an accelerated gas it differs from place to place";
  if (s.has_obstacles()) return "walls and balls of infinite mass are obstacles, which the virial of a gas does not know";
  if (!(VirialPressure::degrees_of_freedom(s) > 0)) return "a single ball in a periodic space collides with nothing";
  return "";
}

/// Whether anything is to be measured.
bool asks(const ObserveSpec& o) { return o.collision_rate || o.mean_free_path || o.pressure || o.speed_histogram; }

}  // namespace

std::vector<Observers::Kind> Observers::kinds_for(const Scene& scene, const Subject& subject) {
  const ObserveSpec& asked = scene.observe;
  ObserveJudgement judgement(scene);
  std::vector<Kind> kinds;
  if (asks(asked) && subject.free == 0)
    judgement.refuse("*", "no ball has a finite mass, so none ever changes its velocity", "Add a ball that is not fixed");
  const auto has_flights = [&](const char* key) {
    if (scene.collision.law == LawKind::restitution) return true;
    judgement.refuse(key, "balls that stick or merge do not go on as they were",
                     "Only collision_rate is measured with law \"stick\" and \"merge\"");
    return false;
  };
  if (asked.collision_rate) kinds.push_back(Kind::collision_rate);
  if (asked.mean_free_path && has_flights("mean_free_path")) kinds.push_back(Kind::free_path);
  if (asked.pressure && has_flights("pressure")) {
    const std::string why = no_virial(subject);
    if (subject.space == SpaceKind::open) {
      judgement.refuse("pressure", "an open space has no volume", "Give [space] kind \"periodic\" or \"box\"");
    } else if (why.empty()) {
      kinds.push_back(Kind::virial_pressure);
    } else if (subject.space == SpaceKind::periodic) {
      judgement.refuse("pressure", why, "In a box, the pressure on the faces can be measured");
    }
    if (subject.space == SpaceKind::box) kinds.push_back(Kind::wall_pressure);
  }
  if (asked.speed_histogram && has_flights("speed_histogram")) kinds.push_back(Kind::speed_histogram);
  judgement.throw_if_any();
  return kinds;
}

Observers::AnyObserver Observers::make(Kind kind, const Subject& subject) {
  switch (kind) {
    case Kind::collision_rate:
      return CollisionRate(subject);
    case Kind::free_path:
      return FreePath(subject);
    case Kind::virial_pressure:
      return VirialPressure(subject);
    case Kind::wall_pressure:
      return WallPressure(subject);
    case Kind::speed_histogram:
      break;
  }
  return SpeedHistogram(subject);
}

Observers::Observers(const Scene& scene, const Simulation& simulation)
    : flights_(asks(scene.observe) ? subject_of(scene, simulation) : Subject{}, Time<double>{}),
      kinds_(kinds_for(scene, flights_.subject())),
      after_events_(scene.observe.after_events),
      seen_(simulation.counts().collisions()) {
  if (!any()) return;
  const Time<double> start = moment(simulation.time());
  flights_.begin(start);
  after_ = last_ = start;
  if (scene.observe.after_time) after_ = std::max(after_, moment(*scene.observe.after_time));
  if (after_ == start && after_events_.value_or(0) <= seen_) begin(start);
}

Time<double> Observers::moment(double t) const {
  const double epochs = t / flights_.subject().epoch_length;  // a power of two: exact
  if (!(std::abs(epochs) < static_cast<double>(last_epoch))) return Time<double>::never();
  const double whole = std::floor(epochs);
  return {static_cast<std::int64_t>(whole), epochs - whole};
}

CollisionSink Observers::sink() {
  if (!any()) return {};
  return [this](const Collision& c) { collision(c); };
}

void Observers::begin(const Time<double>& t) {
  began_ = t;
  flights_.begin(t);
  for (const Kind kind : kinds_) observers_.push_back(make(kind, flights_.subject()));
}

void Observers::collision(const Collision& c) {
  if (!any()) return;
  const Time<double> now{c.epoch, c.offset / flights_.subject().epoch_length};
  if (!began_ && !after_events_ && now > after_) begin(after_);
  if (began_) measure(c, now);
  flights_.go_on(c, now);
  last_ = now;
  ++seen_;
  if (!began_ && after_events_ && seen_ >= *after_events_) begin(now);
}

void Observers::tell(const Flight& flight) {
  for (AnyObserver& any : observers_)
    std::visit(
        [&](auto& o) {
          if constexpr (FlightObserver<std::remove_cvref_t<decltype(o)>>) o.flight(flight);
        },
        any);
}

void Observers::measure(const Collision& c, const Time<double>& now) {
  flights_.end_by(c, now, [this](const Flight& flight) { tell(flight); });
  const double t = elapsed(*began_, now) * flights_.subject().epoch_length;
  for (AnyObserver& any : observers_) std::visit([&](auto& o) { o.collision(c, t, flights_.subject()); }, any);
}

void Observers::end(const Simulation& simulation) {
  if (!any()) return;
  const Time<double> now = std::max(moment(simulation.time()), last_);
  if (!began_ && !after_events_ && now > after_) begin(after_);
  if (!began_) return;
  flights_.end(now, [this](const Flight& flight) { tell(flight); });
  const double t = elapsed(*began_, now) * flights_.subject().epoch_length;
  for (AnyObserver& any : observers_) std::visit([&](auto& o) { o.end(t); }, any);
}

Estimates Observers::estimates() const {
  Estimates all;
  const auto append = [&](const AnyObserver& any) {
    Estimates some = std::visit([](const auto& o) { return o.estimates(); }, any);
    if (!began_)
      for (Estimate& e : some) e = Estimate{e.name};
    std::move(some.begin(), some.end(), std::back_inserter(all));
  };
  if (began_) {
    for (const AnyObserver& any : observers_) append(any);
  } else {
    for (const Kind kind : kinds_) append(make(kind, flights_.subject()));
  }
  return all;
}

std::optional<std::vector<SpeedBin>> Observers::speed_table() const {
  for (const AnyObserver& any : observers_)
    if (const auto* histogram = std::get_if<SpeedHistogram>(&any)) return histogram->table();
  if (std::find(kinds_.begin(), kinds_.end(), Kind::speed_histogram) != kinds_.end()) return std::vector<SpeedBin>{};
  return std::nullopt;
}

}  // namespace carom
