#pragma once
// The smallest sphere that encloses a set of points.

#include <glm/glm.hpp>
#include <span>

#include "scene/scene.h"

namespace crsh::scene {

/// A sphere in double precision.
struct ExactSphere {
  glm::dvec3 centre{0};
  double radius = 0;
};

/// The smallest enclosing sphere, by the algorithm of Bernd Gärtner, "Fast and Robust Smallest Enclosing Balls" (ESA
/// 1999): Welzl's move-to-front recursion over a few points, with pivoting (the farthest point is added until none is
/// outside). Exact up to rounding; the float radius is rounded outwards, so that every point lies inside. Without
/// points it is a sphere of radius 0 at the origin.
[[nodiscard]] Sphere smallest_sphere(std::span<const glm::vec3> points);

/// The smallest sphere around one triangle: around its longest edge where it is obtuse, else its circumscribed sphere.
[[nodiscard]] ExactSphere triangle_sphere(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

/// The least float that is not below x times (1 + 1e-6).
[[nodiscard]] float rounded_outwards(double x);

}  // namespace crsh::scene
