#pragma once
// Keyframe animation of nodes: the value of a channel at a time.

#include "scene/scene.h"

namespace crsh::scene {

/// The channel's value at `seconds`, held before the first and after the last key. Rotations are unit, as x, y, z, w.
[[nodiscard]] glm::vec4 sample(const Channel& channel, double seconds);

}  // namespace crsh::scene
