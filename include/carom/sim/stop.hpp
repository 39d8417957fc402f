#pragma once
// Why a run ended.

#include <cstdint>
#include <string_view>

namespace carom {

enum class Stop : std::uint8_t { until, events, no_events_left, collapse, non_finite, interrupted, packing, pressure };

[[nodiscard]] constexpr std::string_view word(Stop stop) noexcept {
  switch (stop) {
    case Stop::until:
      return "until";
    case Stop::events:
      return "events";
    case Stop::no_events_left:
      return "no_events_left";
    case Stop::collapse:
      return "collapse";
    case Stop::non_finite:
      return "non_finite";
    case Stop::interrupted:
      return "interrupted";
    case Stop::packing:
      return "packing";
    case Stop::pressure:
      return "pressure";
  }
  return "";
}

}  // namespace carom
