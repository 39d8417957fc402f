#pragma once
// Reads [[table]] and judges it.

#include "table_reader.hpp"
#include "table_rules.hpp"

namespace carom::scene_text {

[[nodiscard]] TableSpec read_ready_table(TableReader t);
void judge_tables(Judgement& judgement);

}  // namespace carom::scene_text
