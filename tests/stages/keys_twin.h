#pragma once
// The sort keys again in plain C++, from the same definitions (shaders/lib, shaders/rays/keys), and rays to try them
// on.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "crsh/kinds.h"
#include "shared/ray.h"

namespace crsh::test {

inline uint32_t cell_twin(float place, uint32_t bits) {
  const float last = float((1u << bits) - 1);
  return uint32_t(std::clamp(place * float(1u << bits), 0.0f, last));
}

inline glm::vec2 octahedral_twin(glm::vec3 d) {
  const float inverse = 1.0f / ((std::abs(d.x) + std::abs(d.y)) + std::abs(d.z));
  glm::vec2 p{d.x * inverse, d.z * inverse};
  if (d.y > 0)
    p = {std::copysign(1 - std::abs(p.y), d.x < 0 ? -1.0f : 1.0f),
         std::copysign(1 - std::abs(p.x), d.z < 0 ? -1.0f : 1.0f)};
  return p * 0.5f + 0.5f;
}

inline glm::uvec2 octahedral_cell_twin(glm::vec3 d, uint32_t bits) {
  const glm::vec2 p = octahedral_twin(d);
  return {cell_twin(p.x, bits), cell_twin(p.y, bits)};
}

/// Bits of the coordinates interleaved, the first coordinate's on top.
inline uint32_t interleave_twin(const std::vector<uint32_t>& coordinates, uint32_t bits) {
  uint32_t code = 0;
  for (uint32_t bit = bits; bit-- > 0;)
    for (uint32_t c : coordinates) code = code << 1 | (c >> bit & 1);
  return code;
}

/// By the four quadrants of a square in turn: the curve enters at the near left corner and leaves at the near right
/// one.
inline uint32_t hilbert_twin(uint32_t x, uint32_t y, uint32_t bits) {
  if (bits == 0) return 0;
  const uint32_t half = 1u << (bits - 1), quarter = half * half;
  if (x < half && y < half) return hilbert_twin(y, x, bits - 1);
  if (x < half) return quarter + hilbert_twin(x, y - half, bits - 1);
  if (y >= half) return 2 * quarter + hilbert_twin(x - half, y - half, bits - 1);
  return 3 * quarter + hilbert_twin(half - 1 - y, 2 * half - 1 - x, bits - 1);
}

/// Abramowitz and Stegun 4.4.49, as lib/spherical.glsl has it.
inline float atan_twin(float y, float x) {
  const float longer = std::max(std::abs(x), std::abs(y)), ratio = std::min(std::abs(x), std::abs(y)) * (1.0f / longer);
  const float square = ratio * ratio;
  float p = 0.0028662257f;
  for (float coefficient : {-0.0161657367f, 0.0429096138f, -0.0752896400f, 0.1065626393f, -0.1420889944f, 0.1999355085f,
                            -0.3333314528f, 1.0f})
    p = p * square + coefficient;
  float angle = p * ratio;
  if (std::abs(y) > std::abs(x)) angle = 1.57079632679f - angle;
  if (x < 0) angle = 3.14159265359f - angle;
  return y < 0 ? -angle : angle;
}

/// Theta over pi, (phi + pi) over 2 pi.
inline glm::vec2 spherical_twin(glm::vec3 d) {
  const float level = std::sqrt(d.x * d.x + d.z * d.z);
  return {atan_twin(level, d.y) * 0.318309886184f, atan_twin(d.z, d.x) * 0.159154943092f + 0.5f};
}

/// None for a key that has no twin here.
inline std::optional<uint32_t> key_twin(const std::string& name, glm::vec3 place, glm::vec3 d, uint32_t kind) {
  const auto origin = [&](uint32_t bits) {
    return std::vector{cell_twin(place.x, bits), cell_twin(place.y, bits), cell_twin(place.z, bits)};
  };
  const auto direction = [&](uint32_t bits) {
    const glm::uvec2 c = octahedral_cell_twin(d, bits);
    return std::vector{c.x, c.y};
  };
  if (name == "hilbert") return hilbert_twin(direction(12)[0], direction(12)[1], 12);
  if (name == "octahedral") return interleave_twin(direction(12), 12);
  if (name == "origin-direction") return interleave_twin(origin(5), 5) << 11 | interleave_twin(direction(6), 6) >> 1;
  if (name == "direction-origin") return interleave_twin(direction(6), 6) >> 1 << 15 | interleave_twin(origin(5), 5);
  if (name == "interleaved")
    return interleave_twin({origin(5)[0], origin(5)[1], origin(5)[2], direction(5)[0], direction(5)[1]}, 5);
  if (name == "spherical") {
    const glm::vec2 angles = spherical_twin(d);
    const uint32_t hash = cell_twin(angles.x, 5) << 5 | cell_twin(angles.y, 5);
    return ray_kinds[kind].shares_origin ? hash : (origin(5)[0] << 10 | origin(5)[1] << 5 | origin(5)[2]) << 10 | hash;
  }
  if (name == "creation") return 0;
  return {};
}

/// Rays from the cube -1 .. 1 and some from outside it, along axes and diagonals too.
inline std::vector<shared::Ray> key_rays(uint32_t count, uint32_t kind, uint32_t seed = 3) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> part(-1.1f, 1.1f);
  std::uniform_int_distribution<int> step(-1, 1);
  std::vector<shared::Ray> rays(count);
  for (uint32_t i = 0; i < count; ++i) {
    glm::vec3 d(part(random), part(random), part(random));
    if (i % 16 == 0) d = glm::vec3(step(random), step(random), step(random));
    if (glm::length(d) < 0.01f) d = {0, -1, 0};
    rays[i].origin = glm::vec4(part(random), part(random), part(random), INFINITY);
    rays[i].direction = glm::vec4(glm::normalize(d), float(kind));
  }
  return rays;
}

}  // namespace crsh::test
