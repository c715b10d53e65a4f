#include "scene/packed.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>

namespace crsh::scene {

PackedColour packed_colour(const glm::vec4& rgba) {
  return {glm::packHalf2x16({rgba.r, rgba.g}), glm::packHalf2x16({rgba.b, rgba.a})};
}

glm::vec4 unpacked_colour(PackedColour colour) {
  return {glm::unpackHalf2x16(colour.x), glm::unpackHalf2x16(colour.y)};
}

uint32_t packed_tangent(const glm::vec4& tangent) {
  const glm::vec3 size = glm::abs(glm::vec3(tangent));
  const float sum = size.x + size.y + size.z;
  if (!(sum > 0) || !std::isfinite(sum)) return 0;
  const glm::vec3 d = glm::vec3(tangent) / sum;
  const auto sign = [](float v) { return v >= 0 ? 1.0f : -1.0f; };
  const glm::vec2 square =
      d.z >= 0 ? glm::vec2(d) : glm::vec2((1 - std::abs(d.y)) * sign(d.x), (1 - std::abs(d.x)) * sign(d.y));
  const auto steps = [](float v) { return uint32_t(std::clamp(v * 0.5f + 0.5f, 0.0f, 1.0f) * 32767.0f + 0.5f); };
  return 1u | (tangent.w < 0 ? 2u : 0u) | steps(square.x) << 2 | steps(square.y) << 17;
}

}  // namespace crsh::scene
