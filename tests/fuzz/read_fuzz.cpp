// libFuzzer on the scene reader: no text breaks it, and what it accepts has numbers with an exact value.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "carom/core/error.hpp"
#include "carom/core/rational.hpp"
#include "carom/scene/read.hpp"
#include "carom/scene/validate.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const carom::Scene scene = carom::read_scene(text, "fuzz.toml");
    if (!carom::validate(scene).empty()) __builtin_trap();  // read and valid are one
    for (const carom::BallSpec& b : scene.balls)
      for (const carom::Number& x : b.position)
        if (carom::nearest_double(carom::exact(x)) != x.value) __builtin_trap();
  } catch (const carom::InputError& error) {
    if (error.problems().empty()) __builtin_trap();
    for (const carom::Problem& p : error.problems())
      if (p.text().empty()) __builtin_trap();
  }
  return 0;
}
