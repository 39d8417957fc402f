#include "replay_scene.hpp"

#include <array>
#include <vector>

#include "carom/scene/growing.hpp"

namespace carom {

namespace {

/// Doubles, whatever digits the scene gives.
Json numbers(const Coordinates& x) {
  Json list = Json::array();
  for (const Number& n : x) list.push_back(n.value);
  return list;
}

Json wall(const WallSpec& w) {
  Json j;
  switch (w.kind) {
    case WallKind::segment:
      j = {{"kind", "segment"}, {"from", numbers(w.from)}, {"to", numbers(w.to)}};
      break;
    case WallKind::plane:
      j = {{"kind", "plane"}, {"point", numbers(w.point)}, {"normal", numbers(w.normal)}};
      break;
    case WallKind::circle:
      j = {{"kind", "circle"},
           {"centre", numbers(w.centre)},
           {"radius", w.radius.value},
           {"side", w.side == WallSide::inside ? "inside" : "outside"}};
      break;
    case WallKind::polygon:
      j = {{"kind", "polygon"}, {"vertices", Json::array()}};
      for (const Coordinates& v : w.vertices) j["vertices"].push_back(numbers(v));
      break;
    case WallKind::arc:
      j = {{"kind", "arc"},
           {"centre", numbers(w.centre)},
           {"radius", w.radius.value},
           {"from_angle", w.from_angle.value},
           {"to_angle", w.to_angle.value}};
      if (!w.from.empty()) j["from"] = numbers(w.from);
      if (!w.to.empty()) j["to"] = numbers(w.to);
      break;
    case WallKind::ellipse:
      j = {{"kind", "ellipse"},
           {"centre", numbers(w.centre)},
           {"axes", numbers(w.axes)},
           {"angle", w.angle.value},
           {"side", w.side == WallSide::inside ? "inside" : "outside"}};
      break;
    case WallKind::parabola:
      j = {{"kind", "parabola"},
           {"centre", numbers(w.centre)},
           {"angle", w.angle.value},
           {"focal_length", w.focal_length.value},
           {"half_width", w.half_width.value}};
      break;
    case WallKind::curve:
      j = {{"kind", "curve"},
           {"centre", numbers(w.centre)},
           {"angle", w.angle.value},
           {"cosines", numbers(w.cosines)},
           {"sines", numbers(w.sines)},
           {"side", w.side == WallSide::inside ? "inside" : "outside"}};
      break;
  }
  if (!w.velocity.empty()) j["velocity"] = numbers(w.velocity);
  if (w.opening) j["opening"] = true;
  if (w.table >= 0) j["table"] = w.table;
  if (w.oscillation)
    j["oscillation"] = {{"amplitude", numbers(w.oscillation->amplitude)},
                        {"omega", w.oscillation->omega.value},
                        {"phase", w.oscillation->phase.value}};
  return j;
}

const char* word(SpaceKind kind) {
  return kind == SpaceKind::box ? "box" : kind == SpaceKind::periodic ? "periodic" : "open";
}

/// The space that the balls are in: a gas without [space] makes its own.
Json space(const Scene& scene, const Simulation& simulation) {
  const std::array<double, 3> periods = simulation.periods();
  if (periods[0] == 0)
    return {{"kind", word(scene.space.kind)}, {"lower", numbers(scene.space.lower)}, {"upper", numbers(scene.space.upper)}};
  Json lower = Json::array(), upper = Json::array();
  for (std::size_t k = 0; k < static_cast<std::size_t>(scene.dimension); ++k) {
    const double from = k < scene.space.lower.size() ? scene.space.lower[k].value : 0.0;
    lower.push_back(from);
    upper.push_back(from + periods[k]);
  }
  return {{"kind", "periodic"}, {"lower", lower}, {"upper", upper}};
}

const char* word(LawKind law) { return law == LawKind::stick ? "stick" : law == LawKind::merge ? "merge" : "restitution"; }

}  // namespace

Json replay_scene(const Scene& scene, const Simulation& simulation) {
  Json j{{"title", scene.title},
         {"dimension", scene.dimension},
         {"space", space(scene, simulation)},
         {"acceleration", numbers(scene.motion.acceleration)},
         {"magnetic", scene.motion.magnetic ? scene.motion.magnetic->value : 0.0},
         {"law", word(scene.collision.law)},
         {"start", simulation.time().value},
         {"until", scene.run.until ? Json(scene.run.until->value) : Json(nullptr)},
         {"events", scene.run.events ? Json(*scene.run.events) : Json(nullptr)}};
  j["walls"] = Json::array();
  for (const WallSpec& w : scene.walls) j["walls"].push_back(wall(w));
  j["wall_labels"] = Json::array();
  for (std::uint32_t w = 0; w < simulation.wall_count(); ++w) j["wall_labels"].push_back(simulation.wall_label(w));
  j["names"] = Json::object();
  for (std::size_t i = 0; i < scene.balls.size(); ++i)
    if (!scene.balls[i].name.empty()) j["names"][std::to_string(i)] = scene.balls[i].name;
  const std::uint32_t balls = simulation.ball_count();
  j["balls"] = balls;
  if (balls_grow(scene)) {
    j["radius_growth"] = Json::array();
    for (std::uint32_t i = 0; i < balls; ++i) j["radius_growth"].push_back(simulation.radius_growth(i));
  }
  return j;
}

std::string replay_start(const Scene& scene, const Simulation& simulation) {
  std::vector<double> position, velocity, radius, mass, fixed;
  for (const BallState& b : simulation.balls()) {
    for (const Number& x : b.position) position.push_back(x);
    for (const Number& v : b.velocity) velocity.push_back(v);
    radius.push_back(b.radius);
    mass.push_back(b.mass);
    fixed.push_back(b.index < scene.balls.size() && scene.balls[b.index].fixed ? 1.0 : 0.0);
  }
  std::string bytes;
  for (const auto* column : {&position, &velocity, &radius, &mass, &fixed})
    bytes.append(reinterpret_cast<const char*>(column->data()), column->size() * sizeof(double));
  return bytes;
}

}  // namespace carom
