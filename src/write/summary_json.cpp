#include "carom/write/summary_json.hpp"

#include "carom/write/number_text.hpp"
#include "summary_object.hpp"

namespace carom {

namespace {

Json or_null(const std::optional<Number>& x) { return x ? Json(*x) : Json(nullptr); }

Json energy(const EnergyBalance& e) {
  return {{"initial", e.initial},
          {"final", e.final},
          {"dissipated", e.dissipated},
          {"injected", e.injected},
          {"relative_error", e.relative_error}};
}

Json momentum(const VectorBalance& b) {
  return {{"initial", b.initial}, {"final", b.final}, {"relative_error", or_null(b.relative_error)}};
}

// A scalar in 2-D, a vector in 3-D, nothing on a line.
Json turning(const std::vector<Number>& components) {
  if (components.empty()) return nullptr;
  return components.size() == 1 ? Json(components.front()) : Json(components);
}

Json angular_momentum(const VectorBalance& b) {
  return {{"initial", turning(b.initial)},
          {"final", turning(b.final)},
          {"relative_error", b.initial.empty() ? Json(nullptr) : or_null(b.relative_error)}};
}

Json exactness(const ExactnessSummary& e) {
  return {{"max_gap_error", e.max_gap_error},
          {"max_gap_error_relative", e.max_gap_error_relative},
          {"clamped", e.clamped},
          {"unresolved", e.unresolved},
          {"singular", e.singular},
          {"summed_bounces", e.summed_bounces},
          {"repredicted", e.repredicted}};
}

Json growth(const GrowthSummary& g) {
  const auto known = [](const std::optional<double>& x) { return x ? Json(*x) : Json(nullptr); };
  return {{"packing_fraction", known(g.packing_fraction)}, {"reduced_pressure", known(g.reduced_pressure)}};
}

/// The place of one level of a name: a key, or the element of a list where it ends in [index].
Json& step(Json& place, const std::string& level) {
  const std::size_t bracket = level.find('[');
  if (bracket == std::string::npos || level.back() != ']') return place[level];
  Json& list = place[level.substr(0, bracket)];
  return list[static_cast<Json::size_type>(std::stoul(level.substr(bracket + 1)))];
}

}  // namespace

Json events_object(const EventCounts& e) {
  return {{"ball_ball", e.ball_ball}, {"ball_wall", e.ball_wall}, {"other", e.other}, {"ties", e.ties}};
}

/// A dot in a name goes one level down.
Json observed_object(const Estimates& estimates) {
  Json tree = Json::object();
  for (const Estimate& e : estimates) {
    Json* place = &tree;
    std::size_t from = 0;
    for (std::size_t dot = e.name.find('.'); dot != std::string::npos; dot = e.name.find('.', from)) {
      place = &step(*place, e.name.substr(from, dot - from));
      from = dot + 1;
    }
    step(*place, e.name.substr(from)) = {{"value", e.value}, {"error", e.error}};
  }
  return tree;
}

Json final_object(const std::vector<BallState>& balls) {
  Json list = Json::array();
  for (const BallState& b : balls)
    list.push_back({{"index", b.index},
                    {"name", b.name},
                    {"position", b.position},
                    {"image", b.image},
                    {"unwrapped_position", b.unwrapped_position},
                    {"velocity", b.velocity}});
  return list;
}

Json summary_object(const RunReport& report) {
  const Summary& s = report.summary;
  Json j{{"title", s.title},
         {"dimension", s.dimension},
         {"balls", s.balls},
         {"composition", s.composition},
         {"precision", s.precision},
         {"seed", s.seed},
         {"epoch_length", hex_text(s.epoch_length)},
         {"time", s.time},
         {"stopped_by", word(s.stopped_by)}};
  if (s.stopped) j["stopped"] = {{"reason", s.stopped->reason}, {"balls", s.stopped->balls}, {"time", s.stopped->time}};
  j["events"] = events_object(s.events);
  j["energy"] = energy(s.energy);
  j["momentum"] = momentum(s.momentum);
  j["angular_momentum"] = angular_momentum(s.angular_momentum);
  j["exactness"] = exactness(s.exactness);
  if (s.growth) j["growth"] = growth(*s.growth);
  j["observed"] = observed_object(report.observed);
  if (report.final) j["final"] = final_object(*report.final);
  j["seconds"] = report.seconds;
  j["collisions_per_second"] = report.collisions_per_second();
  j["peak_memory_mb"] = report.peak_memory_mb;
  return j;
}

std::string summary_json(const RunReport& report) { return json_text(summary_object(report)); }

}  // namespace carom
