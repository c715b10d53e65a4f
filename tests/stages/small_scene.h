#pragma once
// Scenes of a few triangles, built in memory.

#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "gpu/recorder.h"
#include "scene/bounding.h"
#include "scene/device/upload.h"
#include "scene/scene.h"
#include "support/device.h"

namespace crsh::test {

inline scene::Material matt(glm::vec3 colour) {
  scene::Material material;
  material.base_colour = glm::vec4(colour, 1);
  material.metallic = 0;
  return material;
}

struct SmallScene {
  scene::Scene scene;
  scene::Pose pose;
  SmallScene() { scene.path = "small.glb"; }

  uint32_t material(scene::Material material) {
    scene.materials.push_back(std::move(material));
    return uint32_t(scene.materials.size() - 1);
  }

  /// Triangles of three positions each; texture coordinates are x and y.
  uint32_t mesh(const std::vector<glm::vec3>& corners, uint32_t material_index, glm::vec3 normal = glm::vec3(0)) {
    scene::Mesh mesh;
    mesh.positions = corners;
    for (uint32_t i = 0; i + 2 < corners.size(); i += 3) mesh.triangles.emplace_back(i, i + 1, i + 2);
    mesh.normals.assign(corners.size(), normal);
    for (const glm::vec3& p : corners) mesh.uv[0].emplace_back(p.x, p.y), mesh.uv[1].emplace_back(p.y, p.x);
    mesh.colours.assign(corners.size(), scene::white);
    mesh.materials.assign(mesh.triangles.size(), material_index);
    scene::fill_bounds(mesh);
    scene.meshes.push_back(std::move(mesh));
    return uint32_t(scene.meshes.size() - 1);
  }

  /// Two triangles from (x0, y0) to (x1, y1) on z = 0, facing +z.
  uint32_t quad(glm::vec2 low, glm::vec2 high, uint32_t material_index) {
    const glm::vec3 a(low, 0), b(high.x, low.y, 0), c(high, 0), d(low.x, high.y, 0);
    return mesh({a, b, c, a, c, d}, material_index);
  }

  void instance(uint32_t mesh_index, const glm::mat4& transform = glm::mat4(1)) {
    scene.instances.push_back({mesh_index, uint32_t(scene.instances.size())});
    pose.instances.push_back(transform);
  }

  [[nodiscard]] scene::GpuScene on(gpu::Recorder& recorder, const scene::LightRig& lights = {}) const {
    scene::GpuScene target = scene::upload(recorder.device(), scene);
    scene::animate(recorder, target, scene, pose, lights);
    return target;
  }
};

}  // namespace crsh::test
