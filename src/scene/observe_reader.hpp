#pragma once
// [observe], read.

#include "carom/scene/scene.hpp"
#include "table_reader.hpp"

namespace carom::scene_text {

[[nodiscard]] ObserveSpec read_observe(TableReader t);

}  // namespace carom::scene_text
