#pragma once
// Do two meetings happen at one moment, exactly? Decided in rational numbers, for balls on their first flights.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "carom/certify/system.hpp"

namespace carom::certify {

/// Two balls (the second so many periods on), or a ball and a piece of a wall, as they are at the start.
struct FirstMeeting {
  std::uint32_t ball = 0;
  std::uint32_t partner = 0;
  std::array<std::int64_t, 3> period{};
  std::optional<std::size_t> piece;
};

/// The coefficients of the overlap function since the start; none where they are no rationals.
[[nodiscard]] std::vector<Rational> exact_gap(const System& system, const FirstMeeting& meeting);

/// The times are the same expression: the polynomials are multiples of each other, or their first roots are equal rationals.
/// False where that cannot be told.
[[nodiscard]] bool same_time(const std::vector<Rational>& p, const std::vector<Rational>& q);

}  // namespace carom::certify
