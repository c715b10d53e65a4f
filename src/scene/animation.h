#pragma once
// Keyframe animation of nodes: the value of a channel at a time.

#include "scene/scene.h"

namespace crsh::scene {

/// The channel's value at `seconds`; before the first key that of the first, after the last that of the last. Rotations
/// are unit quaternions x, y, z, w.
[[nodiscard]] glm::vec4 sample(const Channel& channel, double seconds);

}  // namespace crsh::scene
