// Finer meshes of the same shape.

#include <cmath>

#include "bench/sweep.h"
#include "scene/bounding.h"

namespace crsh::bench {
namespace {

/// A point of a triangle as the weights of its corners, multiples of 1 / n. Two triangles get the same numbers for
/// points on the edge they share, so that no crack opens.
struct Weights {
  double a, b, c;
  template <class Vector>
  [[nodiscard]] Vector of(const Vector& x, const Vector& y, const Vector& z) const {
    Vector sum;
    for (int i = 0; i < Vector::length(); ++i)
      sum[i] = static_cast<float>(a * double(x[i]) + b * double(y[i]) + c * double(z[i]));
    return sum;
  }
};

scene::PackedColour mixed_colour(const Weights& w, scene::PackedColour x, scene::PackedColour y,
                                 scene::PackedColour z) {
  return scene::packed_colour(w.of(scene::unpacked_colour(x), scene::unpacked_colour(y), scene::unpacked_colour(z)));
}

glm::vec4 mixed_tangent(const Weights& w, const glm::vec4& x, const glm::vec4& y, const glm::vec4& z) {
  const glm::vec3 sum = w.of(glm::vec3(x), glm::vec3(y), glm::vec3(z));
  return {glm::dot(sum, sum) > 0 ? glm::normalize(sum) : glm::vec3(x), x.w};
}

void add_vertex(const scene::Mesh& from, const glm::uvec3& t, const Weights& w, scene::Mesh& to) {
  const auto mixed = [&](const auto& values) { return w.of(values[t.x], values[t.y], values[t.z]); };
  const glm::vec3 normal = mixed(from.normals);
  to.positions.push_back(mixed(from.positions));
  to.normals.push_back(glm::dot(normal, normal) > 0 ? glm::normalize(normal) : normal);
  for (size_t set = 0; set < scene::uv_sets; ++set)
    if (!from.uv[set].empty()) to.uv[set].push_back(mixed(from.uv[set]));
  if (!from.tangents.empty())
    to.tangents.push_back(mixed_tangent(w, from.tangents[t.x], from.tangents[t.y], from.tangents[t.z]));
  to.colours.push_back(mixed_colour(w, from.colours[t.x], from.colours[t.y], from.colours[t.z]));
}

/// Adds the n x n parts of a triangle, whose vertices go in rows from corner a on.
void subdivide(const scene::Mesh& from, size_t triangle, uint32_t n, scene::Mesh& to) {
  const auto first = static_cast<uint32_t>(to.positions.size());
  const auto vertex = [&](uint32_t row, uint32_t place) { return first + row * (row + 1) / 2 + place; };
  for (uint32_t row = 0; row <= n; ++row)
    for (uint32_t place = 0; place <= row; ++place)
      add_vertex(from, from.triangles[triangle], {double(n - row) / n, double(row - place) / n, double(place) / n}, to);
  for (uint32_t row = 0; row < n; ++row)
    for (uint32_t place = 0; place <= row; ++place) {
      to.triangles.emplace_back(vertex(row, place), vertex(row + 1, place), vertex(row + 1, place + 1));
      if (place < row)
        to.triangles.emplace_back(vertex(row, place), vertex(row + 1, place + 1), vertex(row, place + 1));
    }
  to.materials.resize(to.triangles.size(), from.materials[triangle]);
}

}  // namespace

scene::Scene subdivided(const scene::Scene& scene, uint32_t n) {
  scene::Scene finer = scene;
  if (n < 2) return finer;
  for (size_t i = 0; i < finer.meshes.size(); ++i) {
    scene::Mesh mesh;
    mesh.name = scene.meshes[i].name;
    for (size_t t = 0; t < scene.meshes[i].triangles.size(); ++t) subdivide(scene.meshes[i], t, n, mesh);
    scene::fill_bounds(mesh);
    finer.meshes[i] = std::move(mesh);
  }
  return finer;
}

}  // namespace crsh::bench
