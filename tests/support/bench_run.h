#pragma once
// Runs of `crsh bench` that the tests look at.

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/program.h"

namespace crsh::test {

inline const std::string glass = CRSH_SOURCE_DIR "/scenes/glass.glb";
inline const std::string moving = CRSH_SOURCE_DIR "/scenes/moving.glb";
inline const std::string cornell = CRSH_SOURCE_DIR "/scenes/cornell.glb";

/// Of a tiny picture, one bounce, and these options.
[[nodiscard]] Outcome bench(std::vector<std::string> options);
/// The same, as JSON; it has to succeed.
[[nodiscard]] nlohmann::json bench_json(std::vector<std::string> options);

[[nodiscard]] std::vector<std::string> labels_of(const nlohmann::json& result);
/// A counter of a run, over all its rays.
[[nodiscard]] uint64_t sum(const nlohmann::json& run, const char* counter);

}  // namespace crsh::test
