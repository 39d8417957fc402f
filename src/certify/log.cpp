#include "log.hpp"

#include <charconv>
#include <cmath>

namespace carom::certify {

namespace {

std::string shortest(double x) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, x).ptr};
}

}  // namespace

Claim claim_of(const Collision& c, double reach, const std::array<double, 3>& periods) {
  Claim claim;
  claim.kind = c.kind == EventKind::ball_ball ? MeetingKind::ball_ball : MeetingKind::ball_wall;
  claim.ball = c.ball.number;
  claim.partner = c.partner.number;
  claim.feature = c.feature;
  claim.lower = claim.upper = c.digits != nullptr ? c.digits->time : shortest(c.time);
  if (claim.kind == MeetingKind::ball_ball)
    for (std::size_t k = 0; k < 3; ++k)
      if (periods[k] > 0)
        claim.period[k] = std::llround((c.ball.position[k] - reach * c.normal[k] - c.partner.position[k]) / periods[k]) +
                          (c.ball.image[k] - c.partner.image[k]);
  return claim;
}

}  // namespace carom::certify
