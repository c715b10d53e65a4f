#include "images/built_scene.h"

#include "scene/bounding.h"

namespace crsh::test {

void Triangles::add_quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d,
                         uint32_t material) {
  const auto first = static_cast<uint32_t>(positions.size());
  positions.insert(positions.end(), {a, b, c, d});
  triangles.insert(triangles.end(), {glm::uvec3(0, 1, 2) + first, glm::uvec3(0, 2, 3) + first});
  materials.insert(materials.end(), {material, material});
}

scene::Material matt(glm::vec3 colour) {
  scene::Material material;
  material.base_colour = glm::vec4(colour, 1);
  material.metallic = 0;
  material.double_sided = true;
  return material;
}

scene::Scene built_scene(const Triangles& triangles, std::vector<scene::Material> materials) {
  scene::Mesh mesh;
  const size_t corners = triangles.positions.size();
  mesh.positions = triangles.positions;
  mesh.triangles = triangles.triangles;
  mesh.materials = triangles.materials;
  mesh.normals.assign(corners, glm::vec3(0));
  mesh.uv[0].assign(corners, glm::vec2(0));
  mesh.uv[1].assign(corners, glm::vec2(0));
  mesh.colours.assign(corners, scene::white);
  scene::fill_bounds(mesh);

  scene::Scene scene;
  scene.path = "built in a test";
  scene.meshes = {std::move(mesh)};
  scene.nodes.resize(1);
  scene.instances = {{0, 0}};
  scene.materials = std::move(materials);
  scene.materials.emplace_back();  // glTF's default
  return scene;
}

}  // namespace crsh::test
