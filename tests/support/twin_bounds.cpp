#include "support/twin_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace crsh::test {
namespace {

using glm::dvec3;

void merge_spheres(Bound& bound, const Bound& other) {
  bound.radius = glm::distance(bound.centre, other.centre) / 2 + std::max(bound.radius, other.radius);
  bound.centre = (bound.centre + other.centre) / 2.0;
}

}  // namespace

double angle_between(const dvec3& a, const dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

Bound bound_of(const shared::Node& node) {
  const double angle = node.cone.w < 1e30f ? std::atan(double(node.cone.w)) : std::numbers::pi;
  return {dvec3(node.sphere), node.sphere.w, dvec3(node.cone), angle};
}

Bound bound_of(const shared::Ray& ray) { return {dvec3(ray.origin), 0, glm::normalize(dvec3(ray.direction)), 0}; }

Bound merged(const Bound& bound, const shared::Ray& ray) {
  const Bound other = bound_of(ray);
  Bound result = bound;
  merge_spheres(result, other);
  const dvec3 x = bound.axis, r = other.axis;
  if (angle_between(x, r) <= bound.angle) return result;
  if (angle_between(x, r) + bound.angle >= std::numbers::pi) {  // past a right angle e lies on r's side
    result.angle = std::numbers::pi;
    return result;
  }
  const dvec3 q = glm::normalize(glm::dot(x, r) * x - r);
  const dvec3 e = x * std::cos(bound.angle) + q * std::sin(bound.angle);
  result.axis = glm::normalize(e + r);
  result.angle = angle_between(result.axis, r);
  return result;
}

Bound merged(const Bound& a, const Bound& b) {
  Bound result = a;
  merge_spheres(result, b);
  result.axis = glm::normalize(a.axis + b.axis);
  result.angle = angle_between(a.axis, b.axis) / 2 + std::max(a.angle, b.angle);
  return result;
}

Bound fitted(std::span<const shared::Ray> rays) {
  dvec3 low(std::numeric_limits<double>::infinity()), high = -low, left = low, right = high;
  for (const shared::Ray& ray : rays) {
    const Bound own = bound_of(ray);
    low = glm::min(low, own.centre), high = glm::max(high, own.centre);
    left = glm::min(left, own.axis), right = glm::max(right, own.axis);
  }
  Bound result{(low + high) / 2.0, 0, glm::normalize(left + right), 0};
  for (const shared::Ray& ray : rays) {
    const Bound own = bound_of(ray);
    result.radius = std::max(result.radius, glm::distance(result.centre, own.centre));
    result.angle = std::max(result.angle, angle_between(result.axis, own.axis));
  }
  return result;
}

bool holds(const Bound& outer, const Bound& inner) {
  const bool origins = glm::distance(outer.centre, inner.centre) + inner.radius <= outer.radius;
  const bool any_direction = outer.angle >= std::numbers::pi;
  return origins && (any_direction || angle_between(outer.axis, inner.axis) + inner.angle <= outer.angle);
}

}  // namespace crsh::test
