#pragma once
// The state of a run in a file: written aside and renamed, so that the name always holds a whole state.

#include <string>

#include "carom/sim/simulation.hpp"

namespace carom {

/// Writes the state to `path`, by way of `path`.part on the same disk. Throws OutputError.
void write_checkpoint(const std::string& path, const Simulation& simulation);

/// Puts the state of a file back into a simulation of the same scene. Throws InputError: no such file, damaged, of another scene or
/// version.
void read_checkpoint(const std::string& path, Simulation& simulation);

}  // namespace carom
