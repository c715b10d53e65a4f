// The smallest enclosing sphere, and the spheres that culling uses.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>
#include <random>

#include "scene/bounding.h"
#include "scene/smallest_sphere.h"

using namespace crsh;
using glm::dvec3;
using glm::vec3;

namespace {

using Points = std::vector<vec3>;

Points random_points(std::mt19937& random, size_t count, float size) {
  std::normal_distribution<float> normal(0, size);
  Points out(count);
  for (vec3& p : out) p = {normal(random), normal(random), normal(random)};
  return out;
}

bool contains(const scene::Sphere& sphere, const Points& points) {
  return std::all_of(points.begin(), points.end(),
                     [&](const vec3& p) { return glm::distance(dvec3(p), dvec3(sphere.centre)) <= sphere.radius; });
}

/// The sphere through all of `on`, centred in their affine hull, by Gaussian elimination of its normal equations.
std::optional<scene::ExactSphere> sphere_through(const std::vector<dvec3>& on) {
  const size_t n = on.size() - 1;
  double m[3][4] = {};
  for (size_t i = 0; i < n; ++i) {
    for (size_t j = 0; j < n; ++j) m[i][j] = 2 * glm::dot(on[i + 1] - on[0], on[j + 1] - on[0]);
    m[i][3] = glm::dot(on[i + 1] - on[0], on[i + 1] - on[0]);
  }
  for (size_t i = 0; i < n; ++i) {
    size_t pivot = i;
    for (size_t k = i; k < n; ++k)
      if (std::abs(m[k][i]) > std::abs(m[pivot][i])) pivot = k;
    std::swap(m[i], m[pivot]);
    if (std::abs(m[i][i]) < 1e-12) return {};
    for (size_t k = 0; k < n; ++k) {
      if (k == i) continue;
      const double f = m[k][i] / m[i][i];
      for (size_t j = i; j < 4; ++j) m[k][j] -= f * m[i][j];
    }
  }
  dvec3 centre = on[0];
  for (size_t i = 0; i < n; ++i) centre += (on[i + 1] - on[0]) * (m[i][3] / m[i][i]);
  return scene::ExactSphere{centre, glm::distance(centre, on[0])};
}

/// The smallest radius over all spheres through two to four of the points that hold them all.
double brute_force_radius(const Points& points) {
  double best = INFINITY;
  for (uint32_t mask = 1; mask < 1u << points.size(); ++mask) {
    std::vector<dvec3> on;
    for (size_t i = 0; i < points.size(); ++i)
      if (mask >> i & 1u) on.emplace_back(points[i]);
    if (on.size() > 4) continue;
    const auto sphere = sphere_through(on);
    if (!sphere || sphere->radius >= best) continue;
    const bool all = std::all_of(points.begin(), points.end(), [&](const vec3& p) {
      return glm::distance(dvec3(p), sphere->centre) <= sphere->radius * (1 + 1e-9);
    });
    if (all) best = sphere->radius;
  }
  return best;
}

void check_smallest(const Points& points, double radius) {
  const scene::Sphere sphere = scene::smallest_sphere(points);
  CHECK(contains(sphere, points));
  const double size = glm::length(sphere.centre) + radius;
  CHECK(sphere.radius <= radius + 1e-6 * size);
}

scene::Mesh mesh_of(Points positions, std::vector<glm::uvec3> triangles) {
  scene::Mesh mesh;
  mesh.positions = std::move(positions);
  mesh.triangles = std::move(triangles);
  scene::fill_bounds(mesh);
  return mesh;
}

glm::mat4 random_transform(std::mt19937& random, bool similar) {
  std::uniform_real_distribution<float> uniform(-1, 1);
  const auto any = [&] { return vec3(uniform(random), uniform(random), uniform(random)); };
  const float scale = std::exp(4 * uniform(random));
  glm::mat4 out = glm::translate(glm::mat4(1), 1000.0f * any());
  out = glm::rotate(out, 3 * uniform(random), glm::normalize(any() + vec3(0.01f)));
  out = glm::scale(out, similar ? vec3(scale, -scale, scale) : scale * any());
  return similar ? out : glm::rotate(out, 3 * uniform(random), vec3(0, 0, 1));
}

}  // namespace

TEST_CASE("random points: the sphere is as small as brute force finds it") {
  std::mt19937 random(1);
  for (int round = 0; round < 2000; ++round) {
    const Points points = random_points(random, 1 + static_cast<size_t>(round) % 8, round % 3 == 0 ? 1e-3f : 10.0f);
    check_smallest(points, brute_force_radius(points));
  }
}

TEST_CASE("degenerate points: none, one, equal, collinear, coplanar, cospherical") {
  CHECK(scene::smallest_sphere({}).radius == 0);
  check_smallest({{3, 4, 5}}, 0);
  check_smallest(Points(50, {3, 4, 5}), 0);
  check_smallest({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {7, 7, 7}, {3, 3, 3}}, 3.5 * std::sqrt(3.0));
  check_smallest({{0, 0, 2}, {1, 0, 2}, {0, 1, 2}, {1, 1, 2}, {0.5f, 0.5f, 2}}, std::sqrt(0.5));
  Points cube;
  for (int i = 0; i < 64; ++i) cube.emplace_back(i & 1, i >> 1 & 1, i >> 2 & 1);
  check_smallest(cube, std::sqrt(0.75));
  std::mt19937 random(2);
  Points ball = random_points(random, 5000, 1);
  for (vec3& p : ball) p = glm::normalize(p) * 3.0f + vec3(100, 0, 0);
  check_smallest(ball, 3);
}

TEST_CASE("a hundred thousand points far from the origin") {
  std::mt19937 random(3);
  Points points = random_points(random, 100000, 1);
  for (vec3& p : points) p += vec3(10000, -10000, 10000);
  points.emplace_back(10020, -10000, 10000);
  points.emplace_back(9980, -10000, 10000);
  check_smallest(points, 20);
}

TEST_CASE("a triangle's sphere is the smallest of its corners") {
  std::mt19937 random(4);
  for (int round = 0; round < 2000; ++round) {
    Points p = random_points(random, 3, 1);
    if (round % 4 == 0) p[2] = p[0] + (p[1] - p[0]) * 0.3f + 1e-6f * p[2];  // slivers
    if (round % 50 == 0) p[2] = p[1];
    const scene::ExactSphere sphere = scene::triangle_sphere(dvec3(p[0]), dvec3(p[1]), dvec3(p[2]));
    for (const vec3& corner : p)
      CHECK(glm::distance(dvec3(corner), sphere.centre) <= sphere.radius * (1 + 1e-7) + 1e-12);
    CHECK(sphere.radius <= scene::smallest_sphere(p).radius * (1 + 1e-7));
  }
}

TEST_CASE("covers hold every triangle's own smallest sphere, before and after any transform") {
  std::mt19937 random(5);
  for (int round = 0; round < 500; ++round) {
    const Points p = random_points(random, 9, 1);
    const scene::Mesh mesh = mesh_of(p, {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}});
    CHECK(mesh.cover_affine >= mesh.cover_similar);
    CHECK(mesh.cover_similar >= mesh.sphere.radius);
    const bool similar = round % 2 == 0;
    const glm::mat4 transform = round == 0 ? glm::mat4(1) : random_transform(random, similar);
    const scene::Sphere moved = scene::transformed_sphere(mesh, transform);
    for (const glm::uvec3& t : mesh.triangles) {
      dvec3 corner[3];
      for (int c = 0; c < 3; ++c) corner[c] = dvec3(vec3(transform * glm::vec4(p[t[c]], 1)));
      const scene::ExactSphere own = scene::triangle_sphere(corner[0], corner[1], corner[2]);
      CHECK(glm::distance(own.centre, dvec3(moved.centre)) + own.radius <= moved.radius);
    }
  }
}

TEST_CASE("a similarity is told from a stretch, also where it mirrors") {
  const scene::Mesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  const float plain = scene::transformed_sphere(mesh, glm::mat4(1)).radius;
  CHECK(plain == doctest::Approx(std::sqrt(0.5)).epsilon(1e-5));
  CHECK(scene::transformed_sphere(mesh, glm::scale(glm::mat4(1), {-2, 2, 2})).radius ==
        doctest::Approx(2 * plain).epsilon(1e-5));
  CHECK(scene::transformed_sphere(mesh, glm::scale(glm::mat4(1), {1, 1, 3})).radius > 3 * plain);
  CHECK(scene::transformed_sphere(mesh, glm::mat4(0)).radius < 1e-5f);
}
