#pragma once
// What an animation's channel aims at: a node and a path, or a pointer (KHR_animation_pointer).

#include <optional>
#include <string>
#include <vector>

#include "scene/gltf/animations.h"
#include "scene/scene.h"

namespace crsh::scene {

/// Elements of the scene with a property in common, and how many numbers that has (0: any).
struct Aim {
  std::vector<Target> targets;  ///< none where the scene does not reach what is aimed at
  uint32_t width = 3;
};

/// Nothing where it is none that crsh animates. Throws a Fault where it names what the file has not.
[[nodiscard]] std::optional<Aim> aim_of_path(const Places& places, const Scene& scene, int64_t node,
                                             const std::string& path);
[[nodiscard]] std::optional<Aim> aim_of_pointer(const Places& places, const Scene& scene, const std::string& pointer);

}  // namespace crsh::scene
