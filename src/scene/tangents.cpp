#include "scene/tangents.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <tuple>
#include <vector>

#include "scene/mikktspace.h"

namespace crsh::scene {
namespace {

constexpr uint32_t none = 0xFFFFFFFFu;
constexpr glm::vec4 no_tangent(0);

bool has_direction(const glm::vec4& tangent) { return glm::vec3(tangent) != glm::vec3(0); }

/// Whose coordinates give the tangents. There is one tangent a vertex, so that a clearcoat's normal map must do with
/// the base's where it has other coordinates.
uint32_t uv_set_of(const Material& material) {
  for (const Slot slot : {Slot::normal, Slot::clearcoat_normal, Slot::anisotropy})
    if (material.texture(slot).texture) return material.texture(slot).texcoord;
  return 0;
}

/// The normal of a triangle without normals; 0 where it has no area.
glm::vec3 flat_normal(const Mesh& mesh, const glm::uvec3& t) {
  const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  const double length = glm::length(normal);
  return length > 0 ? glm::vec3(normal / length) : glm::vec3(0);
}

/// Copies triangles of a mesh into the form that MikkTSpace takes, with the vertices that they use.
class Excerpt {
 public:
  Excerpt(const Mesh& from, uint32_t uv_set) : from_(from), uv_(from.uv[uv_set]) {}

  void add(const glm::uvec3& triangle) {
    glm::uvec3 added;
    for (int c = 0; c < 3; ++c) {
      const uint32_t vertex = triangle[c];
      const bool flat = from_.normals[vertex] == glm::vec3(0);
      added[c] = flat ? append(vertex, flat_normal(from_, triangle)) : kept(vertex);
    }
    mesh.triangles.push_back(added);
  }

  TangentMesh mesh;

 private:
  uint32_t kept(uint32_t vertex) {
    if (kept_.empty()) kept_.assign(from_.positions.size(), none);
    if (kept_[vertex] == none) kept_[vertex] = append(vertex, from_.normals[vertex]);
    return kept_[vertex];
  }

  uint32_t append(uint32_t vertex, const glm::vec3& normal) {
    mesh.positions.push_back(from_.positions[vertex]);
    mesh.normals.push_back(normal);
    mesh.uv.push_back(uv_.empty() ? glm::vec2(0) : uv_[vertex]);
    return static_cast<uint32_t>(mesh.positions.size() - 1);
  }

  const Mesh& from_;
  const std::vector<glm::vec2>& uv_;
  std::vector<uint32_t> kept_;
};

/// Brings corners' tangents to the mesh's vertices.
class Placement {
  struct Other {
    uint32_t vertex;
    glm::vec4 tangent;
    uint32_t triangle, corner;
    [[nodiscard]] auto order() const {
      return std::tuple(vertex, tangent.x, tangent.y, tangent.z, tangent.w, triangle, corner);
    }
  };

 public:
  explicit Placement(Mesh& mesh) : mesh_(mesh), lacking_(mesh.positions.size()) {
    mesh.tangents.resize(mesh.positions.size(), no_tangent);
    for (size_t v = 0; v < lacking_.size(); ++v) {
      lacking_[v] = !has_direction(mesh.tangents[v]);
      if (lacking_[v]) mesh.tangents[v] = no_tangent;
    }
  }

  [[nodiscard]] bool lacks(const glm::uvec3& triangle) const {
    return lacking_[triangle.x] || lacking_[triangle.y] || lacking_[triangle.z];
  }

  /// The first tangent of a vertex stays there; corners with others wait for copies of it.
  void put(uint32_t triangle, const CornerTangents& tangents) {
    for (uint32_t corner = 0; corner < 3; ++corner) {
      const uint32_t vertex = mesh_.triangles[triangle][int(corner)];
      const glm::vec4& tangent = tangents[corner];
      if (!lacking_[vertex] || !has_direction(tangent)) continue;
      if (!has_direction(mesh_.tangents[vertex])) mesh_.tangents[vertex] = tangent;
      if (mesh_.tangents[vertex] != tangent) others_.push_back({vertex, tangent, triangle, corner});
    }
  }

  /// Makes the copies, one for each vertex and tangent.
  void split() {
    std::sort(others_.begin(), others_.end(), [](const Other& a, const Other& b) { return a.order() < b.order(); });
    const auto first_copy = static_cast<uint32_t>(mesh_.positions.size());
    std::vector<uint32_t> copies;
    for (size_t i = 0; i < others_.size(); ++i) {
      const Other& other = others_[i];
      if (i == 0 || other.vertex != others_[i - 1].vertex || other.tangent != others_[i - 1].tangent)
        copies.push_back(other.vertex);
      mesh_.triangles[other.triangle][int(other.corner)] = first_copy + static_cast<uint32_t>(copies.size()) - 1;
    }
    append_copies(mesh_, copies);
    for (const Other& other : others_)
      mesh_.tangents[mesh_.triangles[other.triangle][int(other.corner)]] = other.tangent;
  }

 private:
  Mesh& mesh_;
  std::vector<bool> lacking_;  // vertices without a tangent in the file
  std::vector<Other> others_;
};

/// Tangents from one set of texture coordinates, for the materials that use it.
void place_from(const Mesh& mesh, std::span<const Material> materials, uint32_t uv_set, Placement& placement) {
  Excerpt excerpt(mesh, uv_set);
  std::vector<uint32_t> triangles;
  for (uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const Material& material = materials[mesh.materials[t]];
    if (!needs_tangents(material) || uv_set_of(material) != uv_set || !placement.lacks(mesh.triangles[t])) continue;
    triangles.push_back(t);
    excerpt.add(mesh.triangles[t]);
  }
  const std::vector<CornerTangents> tangents = mikktspace(excerpt.mesh);
  for (size_t i = 0; i < triangles.size(); ++i) placement.put(triangles[i], tangents[i]);
}

template <class T>
void append_copies_of(std::vector<T>& values, std::span<const uint32_t> vertices) {
  if (values.empty()) return;
  values.reserve(values.size() + vertices.size());
  for (const uint32_t vertex : vertices) values.push_back(T(values[vertex]));
}

template <class T>
void append_copies_of(Rows<T>& rows, std::span<const uint32_t> vertices) {
  if (rows.first.empty()) return;
  for (const uint32_t vertex : vertices) {
    for (uint32_t i = rows.first[vertex]; i < rows.first[vertex + 1]; ++i) rows.items.push_back(T(rows.items[i]));
    rows.first.push_back(uint32_t(rows.items.size()));
  }
}

}  // namespace

void append_copies(Mesh& mesh, std::span<const uint32_t> vertices) {
  append_copies_of(mesh.positions, vertices);
  append_copies_of(mesh.normals, vertices);
  append_copies_of(mesh.tangents, vertices);
  append_copies_of(mesh.colours, vertices);
  for (std::vector<glm::vec2>& uv : mesh.uv) append_copies_of(uv, vertices);
  append_copies_of(mesh.influences, vertices);
  append_copies_of(mesh.displacements, vertices);
}

void fill_tangents(Mesh& mesh, std::span<const Material> materials) {
  const auto needs = [&](uint32_t material) { return needs_tangents(materials[material]); };
  if (std::none_of(mesh.materials.begin(), mesh.materials.end(), needs)) return;
  Placement placement(mesh);
  for (uint32_t uv_set = 0; uv_set < uv_sets; ++uv_set) place_from(mesh, materials, uv_set, placement);
  placement.split();
}

void fill_tangents(Scene& scene) {
  std::atomic<size_t> next = 0;
  const auto work = [&] {
    for (size_t i = next++; i < scene.meshes.size(); i = next++) fill_tangents(scene.meshes[i], scene.materials);
  };
  const bool some = std::any_of(scene.materials.begin(), scene.materials.end(), needs_tangents);
  if (!some) return;
  std::future<void> other;
  if (scene.meshes.size() > 1) other = std::async(std::launch::async, work);
  work();
  if (other.valid()) other.get();
}

}  // namespace crsh::scene
