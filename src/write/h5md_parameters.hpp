#pragma once
// What an H5MD file says beside its frames: who made it, from what, and how it ended.

#include "carom/write/trajectory.hpp"
#include "h5.hpp"

namespace carom {

/// The group h5md: version, author, creator.
void write_h5md_group(const h5::Id& file);

void write_parameters(const h5::Id& parameters, const TrajectoryHead& head, const Provenance& provenance);

void write_ending(const h5::Id& parameters, const Ending& ending);

}  // namespace carom
