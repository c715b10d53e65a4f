#pragma once
// What the oracle knows of a scene: drawn triangles in world space, as the device has them, and what each does to a
// ray.

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "oracle/alpha.h"
#include "scene/scene.h"

namespace crsh::test {

struct OracleTriangle {
  glm::vec3 a{0}, b{0}, c{0};             ///< counter-clockwise seen from the front
  bool single_sided = false;              ///< reflection and refraction rays pass its back, and shadow rays past backs
  bool transmissive = false;              ///< shadow rays are tinted, not blocked
  glm::uvec3 tint{0};                     ///< by this, -log2 in 16.16 fixed point
  std::optional<OracleAlpha> alpha = {};  ///< none: all of it is there
};

/// The triangles of the scene, which must outlive them, at time 0 in the order in which they are drawn.
[[nodiscard]] std::vector<OracleTriangle> oracle_triangles(const scene::Scene& scene);

/// The first triangle that differs from the scene's mesh as its instance stands, worked out in double precision, or
/// from its material; empty: none.
[[nodiscard]] std::string difference_from_scene(const std::vector<OracleTriangle>& triangles,
                                                const scene::Scene& scene);

}  // namespace crsh::test
