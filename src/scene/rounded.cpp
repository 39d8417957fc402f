#include "carom/scene/rounded.hpp"

namespace carom {

namespace {

void round(Number& number) { number.text.clear(); }
void round(Coordinates& coordinates) {
  for (Number& number : coordinates) round(number);
}
void round(std::optional<Number>& number) {
  if (number) round(*number);
}
template <class... Fields>
void round_all(Fields&... fields) {
  (round(fields), ...);
}

}  // namespace

Scene rounded_to_double(Scene scene) {
  scene.rounded = true;
  round_all(scene.space.lower, scene.space.upper, scene.space.restitution, scene.motion.acceleration, scene.motion.magnetic,
            scene.collision.restitution, scene.collision.contact_time, scene.collision.reference_speed);
  for (MaterialSpec& m : scene.materials) round(m.restitution);
  for (MaterialPairSpec& m : scene.material_pairs) round(m.restitution);
  for (BallSpec& b : scene.balls) round_all(b.position, b.velocity, b.radius, b.mass, b.radius_growth);
  for (LatticeSpec& l : scene.lattices)
    round_all(l.packing_fraction, l.radius, l.mass, l.temperature, l.gap, l.apex, l.direction, l.radius_growth);
  for (GasSpec& g : scene.gases) round_all(g.packing_fraction, g.radius, g.mass, g.temperature, g.radius_growth);
  for (WallSpec& w : scene.walls)
    round_all(w.from, w.to, w.point, w.normal, w.centre, w.radius, w.velocity, w.restitution);
  for (WallSpec& w : scene.walls)
    if (w.oscillation) round_all(w.oscillation->amplitude, w.oscillation->omega, w.oscillation->phase);
  for (WallSpec& w : scene.walls)
    for (Coordinates& vertex : w.vertices) round(vertex);
  round_all(scene.run.start, scene.run.until, scene.run.until_packing, scene.run.until_reduced_pressure, scene.run.sample_every);
  return scene;
}

}  // namespace carom
