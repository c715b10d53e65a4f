#pragma once
// EXT_mesh_gpu_instancing: one node, many instances.

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "scene/gltf/document.h"
#include "scene/gltf/extension.h"

namespace crsh::scene {

/// Where each instance stands, seen from the node. A Fault where they are more than `max`, or their attributes do not
/// fit together.
[[nodiscard]] std::vector<glm::mat4> instance_transforms(Document& document, const Extension& extension, uint64_t max);

}  // namespace crsh::scene
