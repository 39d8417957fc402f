#include "carom/observe/observers.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "carom/scene/tables.hpp"
#include "judgement.hpp"

namespace carom {

static_assert(Observer<CollisionRate> && Observer<WallPressure> && Observer<VirialPressure>);
static_assert(FlightObserver<FreePath> && FlightObserver<SpeedHistogram>);
static_assert(Observer<Lyapunov> && Observer<BoundaryMap> && Observer<RotationNumber> && Observer<Caustic> &&
              Observer<PhaseSpacePortion> && Observer<WallSequence> && FlightObserver<Poincare>);

namespace {

/// Why the gas has no virial pressure; empty: it has one.
std::string no_virial(const Subject& s) {
  if (s.accelerated()) return "in an accelerated gas it differs from place to place";
  if (s.has_obstacles()) return "walls and balls of infinite mass are obstacles, which the virial of a gas does not know";
  if (!(VirialPressure::degrees_of_freedom(s) > 0)) return "a single ball in a periodic space collides with nothing";
  return "";
}

/// Whether anything is to be measured.
bool asks(const ObserveSpec& o) {
  return o.collision_rate || o.mean_free_path || o.pressure || o.speed_histogram || o.lyapunov || o.boundary_map ||
         o.poincare || o.rotation_number || o.caustic || o.phase_space_portion || o.wall_sequence;
}

}  // namespace

class Observers::Plan {
 public:
  Plan(const Scene& scene, const Simulation& simulation, const Subject& subject)
      : scene_(scene), subject_(subject), judgement_(scene) {
    const ObserveSpec& asked = scene.observe;
    if (asks(asked) && subject.free == 0)
      judgement_.refuse("*", "no ball has a finite mass, so none ever changes its velocity", "Add a ball that is not fixed");
    if (asked.collision_rate) add<CollisionRate>();
    if (asked.mean_free_path && has_flights("mean_free_path")) add<FreePath>();
    if (asked.pressure && has_flights("pressure") && all_stay("pressure")) pressure();
    if (asked.speed_histogram && has_flights("speed_histogram")) add<SpeedHistogram>();
    if (asked.lyapunov && has_flights("lyapunov") && all_stay("lyapunov")) lyapunov();
    if (asked.caustic && has_flights("caustic")) caustic();
    if (asked.poincare && has_flights("poincare")) poincare(*asked.poincare);
    on_the_boundary(simulation);
    judgement_.throw_if_any();
  }

  std::vector<Maker> makers;
  Outlets outlets;

 private:
  template <class O>
  void add() {
    makers.push_back([](const Subject& s) { return AnyObserver(O(s)); });
  }

  bool has_flights(const char* key) {
    if (scene_.collision.law == LawKind::restitution) return true;
    judgement_.refuse(key, "balls that stick or merge do not go on as they were",
                      "Only collision_rate is measured with law \"stick\" and \"merge\"");
    return false;
  }

  bool all_stay(const char* key) {
    if (std::none_of(scene_.walls.begin(), scene_.walls.end(), [](const WallSpec& w) { return w.opening; })) return true;
    judgement_.refuse(key, "balls leave through an opening, which ends their flights", "Ask for survival");
    return false;
  }

  void pressure() {
    const std::string why = no_virial(subject_);
    if (subject_.space == SpaceKind::open) {
      judgement_.refuse("pressure", "an open space has no volume", "Give [space] kind \"periodic\" or \"box\"");
    } else if (why.empty()) {
      add<VirialPressure>();
    } else if (subject_.space == SpaceKind::periodic) {
      judgement_.refuse("pressure", why, "In a box, the pressure on the faces can be measured");
    }
    if (subject_.space == SpaceKind::box) add<WallPressure>();
  }

  void lyapunov() {
    const CollisionSpec& c = scene_.collision;
    if (c.regularise != Regularise::stop || c.simultaneous != Simultaneous::sequential)
      judgement_.refuse("lyapunov", "the tangent map knows impacts of two parties at a constant restitution",
                        "Leave out collision.regularise and collision.simultaneous");
    makers.push_back([spec = *scene_.observe.lyapunov, scene = scene_](const Subject& s) {
      return AnyObserver(Lyapunov(spec, scene, s));
    });
  }

  void caustic() {
    if (refused("caustic", Caustic::refusal(scene_, subject_), "It is known in circles about one centre and in an ellipse")) return;
    makers.push_back([scene = scene_](const Subject& s) { return AnyObserver(Caustic(scene, s)); });
  }

  void poincare(const PoincareSpec& spec) {
    if (refused("poincare", Poincare::refusal(spec, subject_), "Choose another line")) return;
    makers.push_back([spec, rows = outlet("poincare")](const Subject& s) { return AnyObserver(Poincare(spec, *rows, s)); });
  }

  void on_the_boundary(const Simulation& simulation) {
    const ObserveSpec& asked = scene_.observe;
    std::shared_ptr<const Boundary> boundary;
    const auto has_boundary = [&](bool wanted, const char* key) {
      if (!wanted || !has_flights(key)) return false;
      if (refused(key, Boundary::refusal(scene_, subject_), "Give walls of finite length, or fixed balls")) return false;
      if (!boundary) boundary = std::make_shared<const Boundary>(scene_, simulation);
      return true;
    };
    if (has_boundary(asked.boundary_map.has_value(), "boundary_map"))
      makers.push_back([boundary, rows = outlet("boundary_map")](const Subject&) {
        return AnyObserver(BoundaryMap(boundary, *rows));
      });
    if (has_boundary(asked.rotation_number, "rotation_number"))
      makers.push_back([boundary](const Subject& s) { return AnyObserver(RotationNumber(boundary, s)); });
    if (has_boundary(asked.phase_space_portion.has_value(), "phase_space_portion"))
      makers.push_back([boundary, bins = asked.phase_space_portion->bins](const Subject&) {
        return AnyObserver(PhaseSpacePortion(boundary, static_cast<std::size_t>(bins)));
      });
    if (has_boundary(asked.wall_sequence.has_value(), "wall_sequence"))
      makers.push_back([boundary, rows = outlet("wall_sequence")](const Subject& s) {
        return AnyObserver(WallSequence(boundary, *rows, s));
      });
  }

  bool refused(const char* key, const std::string& why, const char* hint) {
    if (!why.empty()) judgement_.refuse(key, why, hint);
    return !why.empty();
  }

  const RowOutlet* outlet(const char* name) { return (outlets[name] = std::make_unique<RowOutlet>()).get(); }

  const Scene& scene_;
  const Subject& subject_;
  ObserveJudgement judgement_;
};

Observers::Observers(const Scene& as_written, const Simulation& simulation)
    : Observers(simulation, has_tables_out(as_written) ? with_tables(as_written) : as_written) {}

Observers::Observers(const Simulation& simulation, const Scene& scene)
    : flights_(asks(scene.observe) ? subject_of(scene, simulation) : Subject{}),
      after_events_(scene.observe.after_events),
      seen_(simulation.counts().collisions()) {
  Plan plan(scene, simulation, flights_.subject());
  outlets_ = std::move(plan.outlets);
  makers_ = std::move(plan.makers);
  if (!any()) return;
  const Time<double> start = flights_.subject().moment;
  after_ = last_ = start;
  if (scene.observe.after_time) after_ = std::max(after_, moment(*scene.observe.after_time));
  if (after_ == start && after_events_.value_or(0) <= seen_) begin(start);
}

Time<double> Observers::moment(double t) const { return moment_of(t, flights_.subject().epoch_length); }

CollisionSink Observers::sink() {
  if (!any()) return {};
  return [this](const Collision& c) { collision(c); };
}

void Observers::begin(const Time<double>& t) {
  began_ = t;
  flights_.begin(t);
  observers_.reserve(makers_.size());
  for (const Maker& make : makers_) observers_.push_back(make(flights_.subject()));
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
  Time<double> now = std::max(moment(simulation.time()), last_);
  if (!began_ && !after_events_ && now > after_) begin(after_);
  if (!began_) return;
  const std::vector<Departure> departures = simulation.departures();
  for (const Departure& d : departures) left(d.ball, moment(d.time));
  if (flights_.subject().free == 0 && !departures.empty()) now = std::max(moment(departures.back().time), last_);
  flights_.end(now, [this](const Flight& flight) { tell(flight); });
  const double t = elapsed(*began_, now) * flights_.subject().epoch_length;
  for (AnyObserver& any : observers_) std::visit([&](auto& o) { o.end(t); }, any);
}

void Observers::left(std::uint32_t ball, const Time<double>& when) {
  flights_.leave(ball, when, [this](const Flight& flight) { tell(flight); });
  const double t = std::max(0.0, elapsed(*began_, when) * flights_.subject().epoch_length);
  for (AnyObserver& any : observers_)
    if (auto* rate = std::get_if<CollisionRate>(&any)) rate->left(t);
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
    for (const Maker& make : makers_) append(make(flights_.subject()));
  }
  return all;
}

std::optional<std::vector<SpeedBin>> Observers::speed_table() const {
  for (const AnyObserver& any : observers_)
    if (const auto* histogram = std::get_if<SpeedHistogram>(&any)) return histogram->table();
  if (began_) return std::nullopt;
  for (const Maker& make : makers_)
    if (std::holds_alternative<SpeedHistogram>(make(flights_.subject()))) return std::vector<SpeedBin>{};
  return std::nullopt;
}

std::vector<Table> Observers::tables() const {
  std::vector<Table> all;
  const auto append = [&](const AnyObserver& any) {
    std::visit(
        [&](const auto& o) {
          if constexpr (std::is_same_v<std::remove_cvref_t<decltype(o)>, Lyapunov>)
            if (const std::optional<Table> table = o.table()) all.push_back(*table);
        },
        any);
  };
  for (const AnyObserver& any : observers_) append(any);
  if (!began_)
    for (const Maker& make : makers_) append(make(flights_.subject()));
  return all;
}

void Observers::stream(const std::string& name, RowSink sink) {
  if (const auto outlet = outlets_.find(name); outlet != outlets_.end()) outlet->second->lead_to(std::move(sink));
}

std::vector<StreamedTable> streamed_tables(const Scene& scene) {
  const ObserveSpec& o = scene.observe;
  std::vector<StreamedTable> list;
  const auto add = [&](const char* name, const std::string& file, std::vector<std::string> columns) {
    list.push_back({name, file.empty() ? std::string(name) + ".csv" : file, std::move(columns)});
  };
  if (o.boundary_map) add("boundary_map", o.boundary_map->file, BoundaryMap::columns());
  if (o.poincare) add("poincare", o.poincare->file, Poincare::columns());
  if (o.wall_sequence) add("wall_sequence", o.wall_sequence->file, WallSequence::columns());
  return list;
}

std::vector<std::string> final_tables(const ObserveSpec& observe) {
  std::vector<std::string> names;
  if (observe.lyapunov && observe.lyapunov->finite_time) names.emplace_back("lyapunov_finite_time");
  return names;
}

}  // namespace carom
