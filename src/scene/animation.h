#pragma once
// Keyframe animation of nodes: reading and sampling.

#include "scene/document.h"
#include "scene/fault.h"
#include "scene/nodes.h"
#include "scene/scene.h"

namespace crsh::scene {

/// Fills animations, in glTF's order. Channels of nodes that the scene does not reach are left out.
void read_animations(Document& document, const NodeMap& nodes, Scene& scene, Notes& notes);

/// The channel's value at `seconds`, held before the first and after the last key. Rotations are unit, as x, y, z, w.
[[nodiscard]] glm::vec4 sample(const Channel& channel, double seconds);

}  // namespace crsh::scene
