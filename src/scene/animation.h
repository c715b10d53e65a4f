#pragma once
// Keyframe animation: the value of a channel at a time, and what all channels make of the scene.

#include "scene/properties.h"
#include "scene/scene.h"

namespace crsh::scene {

/// The channel's value at `seconds`; before the first key that of the first, after the last that of the last. Rotations
/// are unit quaternions x, y, z, w. This is where a time meets keys, and nowhere else: see `reached` in animation.cpp.
[[nodiscard]] std::vector<float> sample(const Channel& channel, double seconds);

/// The scene with its animations applied.
struct Animated {
  std::vector<NodeState> nodes;
  Changes changes;
};

/// At `seconds` of these animations, the later ones over the earlier.
[[nodiscard]] Animated animated(const Scene& scene, double seconds, const std::vector<uint32_t>& animations);

}  // namespace crsh::scene
