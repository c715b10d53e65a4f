#pragma once
// Plain C++ twins of shaders/lib/triangle.glsl and shaders/hierarchy/bounds/sphere-cone.glsl: the same float operations
// in the same order, so that they agree with the shaders bit for bit (the build forbids contraction).

#include <glm/glm.hpp>

#include "shared/node.h"
#include "shared/ray.h"

namespace crsh::test {

struct Triangle {
  glm::vec3 a{0}, b{0}, c{0};
};

struct Meeting {
  bool hit = false;
  float t = 0;
};

/// Centre and padded radius.
[[nodiscard]] glm::vec4 smallest_sphere(const Triangle& triangle);

/// Whether the ray hits the triangle, and where.
[[nodiscard]] Meeting hit_triangle(const shared::Ray& ray, const Triangle& triangle, bool cull_back);

/// Equation 9 (`cone_as_printed`: without the sign) and the interval.
[[nodiscard]] bool may_hit_sphere(const shared::Node& node, const shared::Interval& interval, const glm::vec4& sphere,
                                  bool use_interval, bool cone_as_printed = false);

}  // namespace crsh::test
