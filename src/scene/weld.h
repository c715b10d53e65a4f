#pragma once
// Triangles as tangents are made for them, and which of their vertices are the same.

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace crsh::scene {

/// Triangles with what MikkTSpace looks at. Everything is finite.
struct TangentMesh {
  std::vector<glm::vec3> positions, normals;  ///< normals: unit, or zero
  std::vector<glm::vec2> uv;
  std::vector<glm::uvec3> triangles;
};

/// For each vertex the first that has the same position, normal and texture coordinates.
[[nodiscard]] std::vector<uint32_t> welded(const TangentMesh& mesh);

}  // namespace crsh::scene
