#include "unbuilt.hpp"

#include <algorithm>
#include <array>

#include "words.hpp"

namespace carom::scene_text {

namespace {

struct Unbuilt {
  std::string_view key;
  std::string_view value = {};  // empty: every value
};

// A line is deleted when its feature is there. The value of wall.velocity is the kind of the wall.
constexpr std::array unbuilt{
    Unbuilt{"motion.cloth"},
    Unbuilt{"collision.law", "rough"},
    Unbuilt{"ball.spin"},
    Unbuilt{"ball.inertia"},
};

}  // namespace

bool is_unbuilt(std::string_view key, std::string_view value) {
  return std::any_of(unbuilt.begin(), unbuilt.end(),
                     [&](const Unbuilt& u) { return u.key == key && (u.value.empty() || u.value == value); });
}

std::string unbuilt_message(std::string_view key, std::string_view value) {
  std::string s = "key " + std::string(key);
  if (!value.empty()) s += " = " + in_quotes(value);
  return s + ": not built yet";
}

}  // namespace carom::scene_text
