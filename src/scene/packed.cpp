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

glm::dvec3 uv_metric(const std::array<glm::dvec3, 3>& corners, const std::array<glm::dvec2, 3>& uv) {
  const glm::dvec3 ab = corners[1] - corners[0], ac = corners[2] - corners[0];
  const double bb = glm::dot(ab, ab), bc = glm::dot(ab, ac), cc = glm::dot(ac, ac);
  const double squared = bb * cc - bc * bc;  // of the doubled area
  if (!(squared > 0)) return glm::dvec3(0);
  // J = D inverse(E), D and E having the edges in uv and in space as columns, so that J transposed(J) is D times the
  // inverse of transposed(E) E times transposed(D).
  const glm::dvec2 d = uv[1] - uv[0], e = uv[2] - uv[0];
  const auto element = [&](int i, int j) {
    return (d[i] * d[j] * cc - (d[i] * e[j] + e[i] * d[j]) * bc + e[i] * e[j] * bb) / std::sqrt(squared);
  };
  return {element(0, 0), element(0, 1), element(1, 1)};
}

uint32_t packed_metric(const glm::dvec3& metric) {
  const double largest = std::max({metric.x, std::abs(metric.y), metric.z});
  if (!(largest > 0) || !std::isfinite(largest)) return 0;
  const int exponent = std::clamp(std::ilogb(largest) + 1, -127, 127);  // all are below 2^exponent
  const double unit = std::exp2(exponent - 7);
  const auto steps = [unit](double v, double low, double high) {
    return uint32_t(int(std::clamp(std::round(v / unit), low, high)) + (low < 0 ? 128 : 0));
  };
  return steps(metric.x, 0, 255) | steps(metric.y, -127, 127) << 8 | steps(metric.z, 0, 255) << 16 |
         uint32_t(exponent + 128) << 24;
}

}  // namespace crsh::scene
