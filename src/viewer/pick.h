#pragma once
// What a line of sight meets first, found on the CPU: for a click, not for pictures.

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "scene/scene.h"
#include "viewer/camera.h"

namespace crsh::viewer {

/// The point, in metres, of the first triangle in sight, if any; instances whose `hidden` is set are left out.
[[nodiscard]] std::optional<glm::vec3> pick(const scene::Scene& scene, const scene::Pose& pose,
                                            const std::vector<bool>& hidden, const Sight& sight);

}  // namespace crsh::viewer
