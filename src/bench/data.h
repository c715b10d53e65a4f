#pragma once
// What was measured, for other programs: JSON (schema crsh-bench/1) and CSV.

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/paper_tables.h"
#include "gpu/device.h"

namespace crsh::bench {

/// What the results do not say themselves.
struct Description {
  std::vector<std::string> command;  ///< as it was given
  gpu::DeviceInfo device;
  Schedule schedule;
  /// Every effective option of a variant by its name, for the statistics.
  std::function<nlohmann::ordered_json(const Variant&)> effective;
};

/// {"schema": "crsh-bench/1", "runs": [..]}, an object whose list is "runs": a run is what `crsh render --stats` says
/// of its timed frames (schema crsh-stats/1; of one pass where none was timed), and "bench": label, what varies,
/// whether it was traced and timed, and when each frame's turn was. "repeat" and "warmup" are what was asked for;
/// "budget_s" (0: none) may have made them fewer.
[[nodiscard]] nlohmann::ordered_json bench_json(const Description& description,
                                                const std::vector<SceneResults>& scenes);

/// A row a scene, variant, ray kind and bounce, and one with the kind "all", which alone has times. Counters are of one
/// pass, times medians in milliseconds.
[[nodiscard]] std::string bench_csv(const std::vector<SceneResults>& scenes);

}  // namespace crsh::bench
