#pragma once
// Scenes of boxes anywhere in space, with an oracle that says from the boxes alone which points a light reaches.

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "crsh/options.h"
#include "crsh/picture.h"
#include "scene/scene.h"

namespace crsh::test {

/// Where a scene lies: turned, scaled, moved. Its own lengths are about 1, in double precision.
struct Placement {
  double scale = 1;
  glm::dvec3 offset{0};
  bool turned = false;  ///< about all axes: no face is parallel to one, and no coordinate exact
  [[nodiscard]] glm::dvec3 to_world(const glm::dvec3& point) const;
  [[nodiscard]] glm::dvec3 to_own(const glm::dvec3& point) const;
  [[nodiscard]] glm::dmat3 rotation() const;
};

struct Box {
  glm::dvec3 low{-1}, high{1};
};

/// Boxes, lights and an eye, in the scene's own coordinates.
struct BoxScene {
  std::vector<Box> boxes;
  std::vector<glm::dvec3> lights;
  glm::dvec3 eye{0}, target{0};
  double fov = 60;  ///< degrees, vertical
  Placement placement;
};

/// Two triangles a face of one grey material; no lights or cameras: the options have them.
[[nodiscard]] scene::Scene scene_of(const BoxScene& boxes);

/// A square image from the eye with the lights, none bounces, candela by the scale.
[[nodiscard]] RenderOptions options_of(const BoxScene& boxes, uint32_t size);

/// Matrix of a node whose light shines along a unit vector.
[[nodiscard]] glm::mat4 node_shining(const glm::dvec3& direction);

/// Pixels for which light and shadow are beyond doubt, and what the picture has there.
struct Lighting {
  uint32_t lit = 0, shadowed = 0;  ///< by the oracle
  uint32_t acne = 0;               ///< dark though lit
  uint32_t leaks = 0;              ///< light though shadowed
  std::string first;               ///< of either, a sentence
};

/// Compares a picture under the first light with the oracle. In doubt is what lies within a few times `margin` (own
/// lengths) of the edge of a shadow, and where the light grazes.
[[nodiscard]] Lighting lighting_of(const BoxScene& boxes, const Picture& picture, double margin);

}  // namespace crsh::test
