#pragma once
// What a frame built, for looking at: the nodes over its rays, and the boxes over its objects. Places are measured from
// Renderer::centre().

#include <cstdint>
#include <glm/glm.hpp>

namespace crsh {

/// A node of the ray hierarchy, with any bound: a ball that holds the origins of its rays, and a cone that holds their
/// directions. Metres, radians.
struct RayNode {
  glm::vec3 centre{0};
  float radius = 0;
  glm::vec3 axis{0, 0, 1};
  float half_angle = 0;
  uint32_t kind = 0, bounce = 0, light = 0, level = 1;
  uint32_t first = 0, end = 0;  ///< its rays are those with RayTable::sorted in [first, end)
};

/// A child's box in the object hierarchy.
struct ObjectBox {
  glm::vec3 low{0}, high{0};
  uint32_t depth = 1;  ///< the root's children have 1
};

}  // namespace crsh
