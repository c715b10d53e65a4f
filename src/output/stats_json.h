#pragma once
// `--stats`: schema crsh-stats/1.

#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "crsh/statistics.h"
#include "gpu/device.h"

namespace crsh::output {

/// What is written besides the statistics.
struct RunDescription {
  std::vector<std::string> command;  ///< as it was given
  nlohmann::ordered_json options;    ///< every effective value, by the option's name
  gpu::DeviceInfo device;
  std::string scene;                               ///< path
  glm::dmat4 world_to_camera{1}, world_to_ndc{1};  ///< of the last frame, as in the EXR but in double precision
  uint32_t width = 0, height = 0, samples = 1;
  std::string algorithm;
  bool replayed = false;  ///< the rays came from a file: there is no camera and no image
};

/// Counters are exact 64-bit integers, hits_digest 16 hex digits.
[[nodiscard]] nlohmann::ordered_json stats_json(const RunDescription& run, const Statistics& statistics);

/// A device as the statistics and `crsh info --json` describe it.
[[nodiscard]] nlohmann::ordered_json device_json(const gpu::DeviceInfo& device);

/// This machine: {"cpu", "threads"}.
[[nodiscard]] nlohmann::ordered_json host_json();

}  // namespace crsh::output
