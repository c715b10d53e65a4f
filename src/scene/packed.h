#pragma once
// Vertex attributes in fewer bits.

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

namespace crsh::scene {

/// COLOR_0, RGBA, linear, as four halves: 8 bits would lose what is dark.
using PackedColour = glm::uvec2;
inline constexpr PackedColour white{0x3C003C00u, 0x3C003C00u};
[[nodiscard]] PackedColour packed_colour(const glm::vec4& rgba);
[[nodiscard]] glm::vec4 unpacked_colour(PackedColour colour);

/// A tangent (xyz, of any length; w: the bitangent's sign) as shaders/lib/tangent.glsl unpacks it; 0, no tangent, where
/// it has no length.
[[nodiscard]] uint32_t packed_tangent(const glm::vec4& tangent);

/// How texture coordinates run over a triangle: the elements dudu, dudv, dvdv of J transposed(J) times the triangle's
/// doubled area, J being the derivative of the coordinates by position. 0 for a triangle without area.
[[nodiscard]] glm::dvec3 uv_metric(const std::array<glm::dvec3, 3>& corners, const std::array<glm::dvec2, 3>& uv);
/// The same in a word, to 1/128 of its largest element (shared::StoredTriangle).
[[nodiscard]] uint32_t packed_metric(const glm::dvec3& metric);

}  // namespace crsh::scene
