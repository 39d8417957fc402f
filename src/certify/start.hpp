#pragma once
// Are all balls of a system apart at the start?

#include <cstddef>
#include <string>

#include "carom/certify/system.hpp"

namespace carom::certify {

/// Who is in contact, or cannot be told from it, or overlaps: in words; "" if nobody. Decided on the exact numbers; balls
/// from number `written` on were placed in doubles, and a simulator takes gaps within their rounding for contacts.
[[nodiscard]] std::string contact_at_the_start(const System& system, std::size_t written);

}  // namespace carom::certify
