#include "support/twin.h"

#include <algorithm>
#include <cmath>

namespace crsh::test {
namespace {

using glm::vec3;
using glm::vec4;

constexpr float bound_pad = 0x1p-20f, bound_slack = 1 + bound_pad, wide = 1e30f;

float dot(const vec3& a, const vec3& b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }

float length(const vec3& v) { return std::sqrt(dot(v, v)); }

float largest(const vec3& v) { return std::max(std::max(std::abs(v.x), std::abs(v.y)), std::abs(v.z)); }

float largest(const Triangle& triangle) {
  return std::max(std::max(largest(triangle.a), largest(triangle.b)), largest(triangle.c));
}

vec3 middle_of_sphere(const Triangle& triangle) {
  const auto& [a, b, c] = triangle;
  const vec3 ab = b - a, ac = c - a, bc = c - b;
  const float at_a = dot(ab, ac), at_b = -dot(ab, bc), at_c = dot(ac, bc);
  if (at_a <= 0) return (b + c) * 0.5f;
  if (at_b <= 0) return (a + c) * 0.5f;
  if (at_c <= 0) return (a + b) * 0.5f;
  const float wa = dot(bc, bc) * at_a, wb = dot(ac, ac) * at_b, wc = dot(ab, ab) * at_c;
  const float sum = (wa + wb) + wc;
  return sum > 0 ? a + (ab * wb + ac * wc) / sum : (a + b) * 0.5f;
}

float safe_inverse(float d) { return 1 / (std::abs(d) < 1e-30f ? (d < 0 ? -1e-30f : 1e-30f) : d); }

bool inside_slabs(const vec3& origin, const vec3& direction, float t, const vec3& low, const vec3& high) {
  const vec3 inverse(safe_inverse(direction.x), safe_inverse(direction.y), safe_inverse(direction.z));
  const vec3 first = (low - origin) * inverse, second = (high - origin) * inverse;
  const vec3 near3 = glm::min(first, second), far3 = glm::max(first, second);
  const float enter = std::max(std::max(near3.x, near3.y), near3.z);
  const float leave = std::min(std::min(far3.x, far3.y), far3.z);
  return enter <= t * bound_slack && t <= leave * bound_slack;
}

bool inside_chord(const vec3& origin, const vec3& direction, float t, const vec3& centre, float radius) {
  const vec3 to_centre = centre - origin;
  const float squared = dot(direction, direction);
  const float middle = dot(to_centre, direction) / squared;
  const vec3 across = to_centre - direction * middle;
  const float left = radius * radius - dot(across, across);
  const float half_chord = std::sqrt(std::max(left, 0.0f) / squared) * bound_slack;
  return left >= 0 && std::abs(t - middle) <= half_chord + bound_pad * std::abs(middle);
}

/// Index of the direction's largest component.
int depth_axis(const vec3& direction) {
  const vec3 size = glm::abs(direction);
  return size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
}

vec3 seen_from(const vec3& origin, const vec3& direction, const vec3& corner) {
  const int z = depth_axis(direction), x = (z + 1) % 3, y = (z + 2) % 3;
  const vec3 p = corner - origin;
  return {p[x] - direction[x] / direction[z] * p[z], p[y] - direction[y] / direction[z] * p[z], p[z]};
}

/// Twice the signed area that the ray's point spans with an edge.
float weight(const vec3& p, const vec3& q) { return p.x * q.y - p.y * q.x; }

struct Crossing {
  bool inside = false;
  float towards = 0, t = 0;
};

Crossing crossing(const vec3& origin, const vec3& direction, const Triangle& triangle) {
  const vec3 a = seen_from(origin, direction, triangle.a), b = seen_from(origin, direction, triangle.b),
             c = seen_from(origin, direction, triangle.c);
  const vec3 w(weight(b, c), weight(c, a), weight(a, b));
  const bool inside = glm::all(glm::greaterThanEqual(w, vec3(0))) || glm::all(glm::lessThanEqual(w, vec3(0)));
  const float towards = ((w.x + w.y) + w.z) * direction[depth_axis(direction)];
  return {inside, towards, ((w.x * a.z + w.y * b.z) + w.z * c.z) / towards};
}

}  // namespace

vec4 smallest_sphere(const Triangle& triangle) {
  const vec3 centre = middle_of_sphere(triangle);
  const float radius =
      std::max(std::max(length(triangle.a - centre), length(triangle.b - centre)), length(triangle.c - centre));
  return vec4(centre, radius * bound_slack + bound_pad * largest(triangle));
}

Meeting hit_triangle(const shared::Ray& ray, const Triangle& triangle, bool cull_back) {
  const vec3 origin(ray.origin), direction(ray.direction);
  const auto& [a, b, c] = triangle;
  const auto [inside, towards, t] = crossing(origin, direction, triangle);
  const bool in_range = towards != 0 && t > 0 && t < ray.origin.w;
  if (!inside || !in_range || (cull_back && towards > 0)) return {false, t};

  const vec4 sphere = smallest_sphere(triangle);
  const float largest_origin = largest(origin);
  const float pad = bound_pad * (largest(triangle) + largest_origin);
  const vec3 low = glm::min(glm::min(a, b), c) - vec3(pad), high = glm::max(glm::max(a, b), c) + vec3(pad);
  const float radius = sphere.w + bound_pad * largest_origin;
  return {inside_slabs(origin, direction, t, low, high) && inside_chord(origin, direction, t, vec3(sphere), radius), t};
}

bool may_hit_sphere(const shared::Node& node, const shared::Interval& interval, const vec4& sphere, bool use_interval,
                    bool cone_as_printed) {
  const vec3 axis(node.cone), v = vec3(sphere) - vec3(node.sphere);
  const float tangent = node.cone.w, reach = node.sphere.w + sphere.w;
  const float along = dot(v, axis);
  const vec3 across = v - axis * along;
  const float slack = 2 * bound_pad * (length(v) + reach);
  const float secant = std::sqrt(1 + tangent * tangent);
  const float to_foot = cone_as_printed ? std::abs(along) : along;
  const float allowed = to_foot * tangent + (reach + slack) * secant;
  if (use_interval && length(v) - reach - slack > interval.far_end * bound_slack) return false;
  if (!(tangent < wide)) return true;
  return length(across) <= allowed && (cone_as_printed || along + reach + slack >= 0);
}

}  // namespace crsh::test
