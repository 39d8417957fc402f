#pragma once
// A random scene as the text of its file: few balls, much that can coincide.

#include <cstdint>
#include <string>

namespace carom::testing {

/// The scene of this number: the same text on every machine. Half of them lie on a coarse grid, so that contacts are exact
/// and events simultaneous; some mix masses of 1e-12..1e12, speeds of 2^-40..2^40 and radii of 2^-8..1.
[[nodiscard]] std::string any_scene(std::uint64_t number);

}  // namespace carom::testing
