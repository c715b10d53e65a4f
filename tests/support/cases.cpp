#include "support/cases.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace crsh::test {
namespace {

using glm::vec3;

constexpr float no_end = std::numeric_limits<float>::infinity();

/// The edges of a triangle, from its first corner.
struct Edges {
  vec3 ab{0}, ac{0};
};

Edges hard_edges(Random& random, float size) {
  const vec3 u = random.unit() * size, v = random.unit() * size;
  switch (random.below(7)) {
    case 0: return {u, u * random.uniform(-1, 2) + v * random.scale(1e-7f, 1e-2f)};  // sliver
    case 1: return {vec3(0), random.below(2) ? vec3(0) : u};                         // point, or without area
    case 2: return {u, u * random.uniform(-1, 2)};                                   // near-degenerate
    case 3: return {vec3(u.x, 0, 0), vec3(0, u.y, 0)};                               // axis-aligned
    case 4: return {vec3(0, u.y, u.z), vec3(0, v.y, v.z)};                           // in an axis-aligned plane
    default: return {u, v};
  }
}

Triangle hard_triangle(Random& random) {
  const bool is_far = random.below(5) == 0;
  const vec3 corner = is_far ? random.unit() * 1e4f : random.point(1);
  const uint32_t size = random.below(6);
  const Edges edges = hard_edges(random, size == 0 ? 1e4f : size == 1 ? 1e-5f : random.scale(1e-3f, 1.0f));
  return {corner, corner + edges.ab, corner + edges.ac};
}

float some_reach(Random& random) {
  switch (random.below(5)) {
    case 0: return no_end;
    case 1: return random.uniform(0.5f, 1);
    case 2: return 1 + random.scale(1e-7f, 1e-4f);
    case 3: return 1;
    default: return random.uniform(1, 2);
  }
}

const Triangle& any_of(Random& random, const std::vector<Triangle>& triangles) {
  return triangles[random.below(uint32_t(triangles.size()))];
}

float size_of(const Triangle& triangle) {
  return std::max({glm::distance(triangle.a, triangle.b), glm::distance(triangle.a, triangle.c), 1e-6f});
}

/// A direction that hardly leaves the triangle's plane.
vec3 along_plane(Random& random, const Triangle& triangle) {
  const vec3 ab = triangle.b - triangle.a, ac = triangle.c - triangle.a, normal = glm::cross(ab, ac);
  const float area = glm::length(normal);
  const vec3 within = glm::length(ab) > 0 ? glm::normalize(ab) : random.unit();
  return within + (area > 0 ? normal / area : random.unit()) * random.scale(1e-7f, 1e-1f);
}

}  // namespace

float Random::scale(float low, float high) { return low * std::pow(high / low, uniform(0, 1)); }

vec3 Random::unit() {
  for (;;) {
    const vec3 v = point(1);
    const float squared = glm::dot(v, v);
    if (squared > 0.01f && squared < 1) return v / std::sqrt(squared);
  }
}

std::vector<Triangle> hard_triangles(Random& random, size_t count) {
  std::vector<Triangle> triangles;
  while (triangles.size() < count) triangles.push_back(hard_triangle(random));
  return triangles;
}

std::vector<Triangle> closed_mesh(uint32_t splits, const vec3& centre, float radius) {
  const float g = 1.6180340f;
  std::vector<vec3> corners = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                               {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  std::vector<glm::uvec3> faces = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                                   {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                                   {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (uint32_t split = 0; split < splits; ++split) {
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> known;
    const auto between = [&](uint32_t a, uint32_t b) {
      const auto [entry, is_new] = known.try_emplace(std::minmax(a, b), uint32_t(corners.size()));
      if (is_new) corners.push_back(glm::normalize(corners[a]) + glm::normalize(corners[b]));
      return entry->second;
    };
    std::vector<glm::uvec3> smaller;
    for (const glm::uvec3& f : faces) {
      const glm::uvec3 m(between(f.x, f.y), between(f.y, f.z), between(f.z, f.x));
      smaller.insert(smaller.end(), {{f.x, m.x, m.z}, {f.y, m.y, m.x}, {f.z, m.z, m.y}, m});
    }
    faces = std::move(smaller);
  }
  for (vec3& corner : corners) corner = glm::normalize(corner) * radius + centre;
  std::vector<Triangle> triangles;
  for (const glm::uvec3& f : faces) triangles.push_back({corners[f.x], corners[f.y], corners[f.z]});
  return triangles;
}

std::vector<Triangle> wall(uint32_t n) {
  std::vector<Triangle> triangles;
  const auto corner = [&](uint32_t x, uint32_t y) {
    return vec3(2 * float(x) / float(n) - 1, 2 * float(y) / float(n) - 1, 0);
  };
  for (uint32_t y = 0; y < n; ++y)
    for (uint32_t x = 0; x < n; ++x) {
      triangles.push_back({corner(x, y), corner(x + 1, y), corner(x + 1, y + 1)});
      triangles.push_back({corner(x, y), corner(x + 1, y + 1), corner(x, y + 1)});
    }
  return triangles;
}

vec3 place_on(Random& random, const Triangle& triangle) {
  const auto& [a, b, c] = triangle;
  const float u = random.uniform(0, 1), v = random.uniform(0, 1 - u);
  switch (random.below(4)) {
    case 0: return random.below(2) ? a : b;
    case 1: return c + (b - c) * u;
    default: return a + (b - a) * u + (c - a) * v;
  }
}

shared::Ray ray_between(const vec3& a, const vec3& b, uint32_t kind, float reach) {
  const vec3 way = b - a;
  const float distance = glm::length(way);
  const vec3 direction = distance > 0 ? way / distance : vec3(0, 0, 1);
  return {glm::vec4(a, reach == no_end ? no_end : reach * distance), glm::vec4(direction, float(kind))};
}

std::vector<shared::Ray> light_rays(Random& random, const std::vector<Triangle>& triangles, size_t count) {
  const vec3 light = random.unit() * random.scale(0.5f, 1e3f);
  std::vector<shared::Ray> rays;
  while (rays.size() < count)
    rays.push_back(
        ray_between(light, place_on(random, any_of(random, triangles)), shared::kind_shadow, some_reach(random)));
  return rays;
}

std::vector<shared::Ray> mirror_rays(Random& random, const std::vector<Triangle>& triangles, size_t count,
                                     uint32_t kind) {
  const vec3 middle = random.point(2);
  const float spread = random.scale(1e-4f, 1);
  std::vector<shared::Ray> rays;
  while (rays.size() < count) {
    const vec3 origin = middle + random.point(spread);
    rays.push_back(ray_between(origin, place_on(random, any_of(random, triangles)), kind));
  }
  return rays;
}

std::vector<shared::Ray> stray_rays(Random& random, const std::vector<Triangle>& triangles, size_t count,
                                    uint32_t kind) {
  std::vector<shared::Ray> rays;
  while (rays.size() < count) {
    const Triangle& triangle = any_of(random, triangles);
    const vec3 place = place_on(random, triangle);
    const float distance = random.scale(0.1f, 100) * size_of(triangle);
    switch (random.below(3)) {
      case 0:
        rays.push_back(ray_between(place - along_plane(random, triangle) * distance, place, kind, some_reach(random)));
        break;
      case 1: rays.push_back(ray_between(place + random.unit() * distance, place, kind, some_reach(random))); break;
      default: rays.push_back(ray_between(random.point(3), random.point(3), kind, some_reach(random))); break;
    }
  }
  return rays;
}

}  // namespace crsh::test
