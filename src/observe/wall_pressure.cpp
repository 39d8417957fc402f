#include "carom/observe/wall_pressure.hpp"

namespace carom {

WallPressure::WallPressure(const Subject& subject)
    : faces_(2 * static_cast<std::size_t>(subject.dimension)), sums_(subject.epoch_length) {
  for (std::size_t face = 0; face < faces_; ++face) area_[face] = subject.volume() / subject.edge[face / 2];
}

void WallPressure::pass(double t) {
  sums_.spread(last_, t, {t - last_});
  last_ = t;
}

void WallPressure::collision(const Collision& c, double t, const Subject& subject) {
  if (c.kind != EventKind::ball_wall || c.partner.number < subject.walls) return;
  pass(t);
  BlockSums<1 + most_faces>::Sums sums{};
  sums.at(1 + c.partner.number - subject.walls) = c.impulse;
  sums_.add(t, sums);
}

void WallPressure::end(double t) {
  pass(t);
  sums_.end(t);
}

Estimates WallPressure::estimates() const {
  using Sums = decltype(sums_)::Sums;
  Estimates list{sums_.estimate("pressure.wall", [this](const Sums& s) {
    double impulse = 0, area = 0;
    for (std::size_t face = 0; face < faces_; ++face) {
      impulse += s[1 + face];
      area += area_[face];
    }
    return impulse / (s[0] * area);
  })};
  for (std::size_t face = 0; face < faces_; ++face)
    list.push_back(sums_.estimate(std::string("pressure.face.") + "xyz"[face / 2] + "-+"[face % 2],
                                  [&](const Sums& s) { return s[1 + face] / (s[0] * area_[face]); }));
  return list;
}

}  // namespace carom
