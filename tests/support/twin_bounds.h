#pragma once
// Node bounds in double precision: equations 1 to 8 (section 3.2.4) as printed, and what it means for one to hold
// another.

#include <glm/glm.hpp>
#include <span>

#include "shared/node.h"
#include "shared/ray.h"

namespace crsh::test {

/// Sphere of origins and cone of directions; `angle` is half of the cone's, in radians.
struct Bound {
  glm::dvec3 centre{0};
  double radius = 0;
  glm::dvec3 axis{0};
  double angle = 0;
};

/// As the node says; a cone that rejects nothing has the angle pi.
[[nodiscard]] Bound bound_of(const shared::Node& node);
[[nodiscard]] Bound bound_of(const shared::Ray& ray);

/// Equations 1 to 4, 7 and 8.
[[nodiscard]] Bound merged(const Bound& bound, const shared::Ray& ray);
/// Equations 5 to 8.
[[nodiscard]] Bound merged(const Bound& a, const Bound& b);
/// About the middle of the origins' box and of the directions' box.
[[nodiscard]] Bound fitted(std::span<const shared::Ray> rays);

/// The angle between two directions that need not be of unit length.
[[nodiscard]] double angle_between(const glm::dvec3& a, const glm::dvec3& b);

/// Whether all of `inner` lies in `outer`, without tolerance.
[[nodiscard]] bool holds(const Bound& outer, const Bound& inner);

}  // namespace crsh::test
