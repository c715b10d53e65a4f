#pragma once
// Tangents by the algorithm that glTF 2.0 (section 3.7.2.1) names for files that have none, MikkTSpace: M. Mikkelsen,
// "Simulation of Wrinkled Surfaces Revisited", 2008, and mikktspace.com. Normal maps are baked with it.

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "scene/weld.h"

namespace crsh::scene {

/// Tangents at a triangle's corners: xyz unit; w: 1 or -1, the sign for which w * cross(normal, tangent) goes up in a
/// picture, against v. All 0 where texture coordinates give no direction.
using CornerTangents = std::array<glm::vec4, 3>;

/// The tangents of each triangle. Takes time n log n for n triangles, whatever they are.
[[nodiscard]] std::vector<CornerTangents> mikktspace(const TangentMesh& mesh);

}  // namespace crsh::scene
