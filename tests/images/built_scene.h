#pragma once
// Scenes made in the tests, of one mesh.

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "scene/scene.h"

namespace crsh::test {

struct Triangles {
  std::vector<glm::vec3> positions;
  std::vector<glm::uvec3> triangles;
  std::vector<uint32_t> materials;  ///< a triangle

  /// Two triangles; corners counter-clockwise seen from the front.
  void add_quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d, uint32_t material = 0);
};

/// Double-sided, rough, no metal.
[[nodiscard]] scene::Material matt(glm::vec3 colour);

/// One mesh, flat shaded, in one instance where it is; no lights, no cameras.
[[nodiscard]] scene::Scene built_scene(const Triangles& triangles, std::vector<scene::Material> materials);

}  // namespace crsh::test
