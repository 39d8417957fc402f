#pragma once
// All of the library: scenes, from files or code; simulations; what they measured; proofs; files of results.

#include "carom/certify/certify.hpp"
#include "carom/core/error.hpp"
#include "carom/core/number.hpp"
#include "carom/scene/read.hpp"
#include "carom/scene/scene.hpp"
#include "carom/scene/validate.hpp"
#include "carom/sim/fixed_step.hpp"
#include "carom/sim/simulation.hpp"
#include "carom/write/events_csv.hpp"
#include "carom/write/summary_json.hpp"
#include "carom/write/summary_table.hpp"
#include "carom/write/trajectory_csv.hpp"
