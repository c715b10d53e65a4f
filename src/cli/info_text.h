#pragma once
// What `crsh info` says of devices and scenes. JSON: schema crsh-info/1.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gpu/device.h"
#include "scene/scene.h"

namespace crsh::cli {

[[nodiscard]] std::string devices_text(const std::vector<gpu::DeviceInfo>& devices);
[[nodiscard]] nlohmann::ordered_json devices_json(const std::vector<gpu::DeviceInfo>& devices);

/// The scene at time 0.
[[nodiscard]] std::string scene_text(const scene::Scene& scene);
[[nodiscard]] nlohmann::ordered_json scene_json(const scene::Scene& scene);

}  // namespace crsh::cli
