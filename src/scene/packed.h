#pragma once
// Vertex attributes in fewer bits.

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

}  // namespace crsh::scene
