#pragma once
// What each option of a preset is worth: tests with it set back to what the paper does.

#include <vector>

#include "bench/paper_tables.h"
#include "bench/table.h"

namespace crsh::bench {

/// `scenes` have the same variants of one preset, that itself first: their tests, and how many times the first one's.
[[nodiscard]] Table ablation_table(const std::vector<SceneResults>& scenes, const RayFilter& filter);

}  // namespace crsh::bench
