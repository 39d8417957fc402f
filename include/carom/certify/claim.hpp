#pragma once
// What a log says of one event: who meets whom, and about when.

#include <array>
#include <cstdint>
#include <string>

namespace carom::certify {

enum class MeetingKind : std::uint8_t { ball_ball, ball_wall };

struct Claim {
  MeetingKind kind = MeetingKind::ball_ball;
  std::uint32_t ball = 0;                ///< ball_ball: the smaller number
  std::uint32_t partner = 0;             ///< ball number, or wall number
  std::int32_t feature = 0;              ///< of the wall
  std::array<std::int64_t, 3> period{};  ///< periods to be added to the partner's unwrapped position
  std::string lower, upper;              ///< [time] decimals between which it happens
  bool enclosed = false;                 ///< false: no such claim is made, it happens about at `lower`
};

}  // namespace carom::certify
