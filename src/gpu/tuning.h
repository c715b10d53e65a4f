#pragma once
// What is chosen by the kind of device, for speed alone: every choice gives the same bytes.
//
// On a CPU a lane's access to memory takes time and arithmetic hardly any, cores are few, and lanes that add to one
// counter wait for each other: so lanes take long runs, and share what they load. A GPU wants many short runs side by
// side, and loads once by itself what all lanes read.

#include <cstdint>

namespace crsh::gpu {

/// How a list is cut up.
struct Runs {
  uint32_t length = 0;  ///< elements that one lane takes; a multiple of 4
  uint32_t group = 0;   ///< lanes of a workgroup
};

struct Tuning {
  bool share_loads = false;              ///< where lanes read one list, each loads a part and passes it round
  uint32_t nodes_a_cluster = 1;          ///< that lanes which walk nodes together take one after the other
  uint32_t sort_lanes = 0;               ///< so many sort, by digits of the width that costs least; 0: by `sort_runs`
  uint32_t sort_digit_bits = 0;          ///< a pass, where runs are given
  Runs sort_runs, scan_runs, fill_runs;  ///< of radix sort, prefix sum, and places that are filled from a few values
};

inline constexpr Tuning cpu_tuning{.share_loads = true,
                                   .nodes_a_cluster = 16,
                                   .sort_lanes = 32,
                                   .sort_runs = {0, 8},
                                   .scan_runs = {256, 16},
                                   .fill_runs = {256, 16}};
inline constexpr Tuning gpu_tuning{
    .sort_digit_bits = 4, .sort_runs = {64, 64}, .scan_runs = {16, 64}, .fill_runs = {16, 64}};

/// The environment's CRSH_TUNING, "cpu" or "gpu", if it is set, so that either kind can be tested on the other; else
/// what suits the device. Throws UserError for anything else.
[[nodiscard]] const Tuning& choose_tuning(bool software);

}  // namespace crsh::gpu
