#pragma once
// What a ray from the eye meets first, found on the CPU: for a click, not for pictures.

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "scene/scene.h"

namespace crsh::viewer {

/// The point, in metres, of the first triangle that the ray meets; instances with `hidden` are not there.
[[nodiscard]] std::optional<glm::vec3> pick(const scene::Scene& scene, const scene::Pose& pose,
                                            const std::vector<bool>& hidden, glm::vec3 origin, glm::vec3 direction);

}  // namespace crsh::viewer
