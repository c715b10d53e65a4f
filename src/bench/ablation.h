#pragma once
// What each switch of a preset is worth: how many tests there are with it set back to what the paper does.

#include <vector>

#include "bench/paper_tables.h"
#include "bench/table.h"

namespace crsh::bench {

/// A table of tests, and of how many times the first variant's they are. All scenes have the same variants of one
/// preset; the first is the preset itself.
[[nodiscard]] Table ablation_table(const std::vector<SceneResults>& scenes, const RayFilter& filter);

}  // namespace crsh::bench
