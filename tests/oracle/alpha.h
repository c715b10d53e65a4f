#pragma once
// The oracle's own idea of alpha (glTF's alphaMode MASK and BLEND): how much of a triangle is there.

#include <array>
#include <glm/glm.hpp>
#include <optional>

#include "scene/scene.h"

namespace crsh::test {

/// Numbers of which one is right.
struct Range {
  double low = 0, high = 0;
};

/// Of a triangle whose material is not opaque. It points into the scene.
struct OracleAlpha {
  std::array<glm::dvec2, 3> uv{};  ///< of the base colour's texture, transformed
  glm::dvec3 corners{1};           ///< vertex colours' alpha times the material's
  double least = 0;                ///< what is less is not there: MASK's cutoff; BLEND: 1/256
  bool blends = false;
  const scene::Texture* texture = nullptr;  ///< null: alpha is the corners' alone
  const scene::Image* image = nullptr;

  /// With these weights of the corners b and c.
  [[nodiscard]] double at(const glm::dvec2& weights) const;
  /// The same where weights are known to `off`, and a little beyond for float32's rounding.
  [[nodiscard]] Range around(const glm::dvec2& weights, double off) const;
};

/// Of a triangle with these corners; nothing where all of it is there.
[[nodiscard]] std::optional<OracleAlpha> oracle_alpha(const scene::Scene& scene, const scene::Mesh& mesh,
                                                      const scene::Material& material, const glm::uvec3& corners);

}  // namespace crsh::test
