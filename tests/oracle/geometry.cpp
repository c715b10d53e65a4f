#include "oracle/geometry.h"

#include <fmt/format.h>

#include <bit>

#include "gpu/recorder.h"
#include "scene/deform.h"
#include "scene/device/upload.h"
#include "scene/playing.h"
#include "support/device.h"

namespace crsh::test {
namespace {

scene::Pose first_pose(const scene::Scene& scene) { return scene.pose(0, scene::playing(scene, "").animations); }

/// Farther than a few roundings of float32 that begin with numbers of this size.
bool apart(const glm::vec3& found, const glm::dvec3& wanted, double size) {
  const glm::dvec3 off = glm::abs(glm::dvec3(found) - wanted);
  return !(std::max({off.x, off.y, off.z}) <= 1e-6 * size);
}

/// The largest sum of magnitudes that the transformed point is made of.
double size_of(const glm::dmat4& m, const glm::dvec3& p) {
  double size = 0;
  for (int row = 0; row < 3; ++row)
    size = std::max(
        size, std::abs(m[0][row] * p.x) + std::abs(m[1][row] * p.y) + std::abs(m[2][row] * p.z) + std::abs(m[3][row]));
  return size;
}

bool same_corner(const glm::vec3& found, const glm::mat4& transform, const glm::vec3& position) {
  const glm::dmat4 m(transform);
  return !apart(found, glm::dvec3(m * glm::dvec4(position, 1)), size_of(m, position));
}

/// Of the scene's materials, in the order in which its triangles are drawn.
std::vector<std::optional<OracleAlpha>> alphas(const scene::Scene& scene) {
  const scene::Pose pose = first_pose(scene);
  std::vector<std::optional<OracleAlpha>> out;
  for (uint32_t instance = 0; instance < scene.instances.size(); ++instance) {
    const scene::Mesh& mesh = scene.meshes[scene.instances[instance].mesh];
    const bool mirrored = scene::is_mirrored(scene, pose, instance);
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
      glm::uvec3 corners = mesh.triangles[t];
      if (mirrored) std::swap(corners.y, corners.z);
      out.push_back(oracle_alpha(scene, mesh, scene.materials[mesh.materials[t]], corners));
    }
  }
  return out;
}

}  // namespace

std::vector<OracleTriangle> oracle_triangles(const scene::Scene& scene) {
  gpu::Recorder recorder(device());
  scene::GpuScene target = scene::upload(device(), scene);
  scene::animate(recorder, target, scene, first_pose(scene), {});
  const auto a = recorder.read<glm::vec4>(target.corner_a, target.triangle_count),
             b = recorder.read<glm::vec4>(target.corner_b, target.triangle_count),
             c = recorder.read<glm::vec4>(target.corner_c, target.triangle_count);
  const auto materials = recorder.read<shared::Material>(target.materials, scene.materials.size());
  const std::vector<std::optional<OracleAlpha>> alpha = alphas(scene);
  std::vector<OracleTriangle> triangles;
  for (size_t i = 0; i < a.size(); ++i) {
    const uint32_t flags = std::bit_cast<uint32_t>(a[i].w);
    triangles.push_back({glm::vec3(a[i]), glm::vec3(b[i]), glm::vec3(c[i]), (flags & shared::triangle_cull_back) != 0,
                         (flags & shared::triangle_transmissive) != 0,
                         glm::uvec3(materials.at(flags & shared::triangle_material_mask).tint), alpha.at(i)});
  }
  return triangles;
}

std::string difference_from_scene(const std::vector<OracleTriangle>& triangles, const scene::Scene& scene) {
  const scene::Pose pose = first_pose(scene);
  size_t i = 0;
  for (uint32_t instance = 0; instance < scene.instances.size(); ++instance) {
    const scene::Mesh& mesh = scene.meshes[scene.instances[instance].mesh];
    const glm::mat4& m = pose.instances[instance];
    const bool mirrored = scene::is_mirrored(scene, pose, instance);
    const std::vector<glm::vec3> positions = scene::posed_positions(scene, pose, instance);
    for (size_t t = 0; t < mesh.triangles.size(); ++t, ++i) {
      if (i >= triangles.size()) return "triangles are missing";
      const OracleTriangle& found = triangles[i];
      glm::uvec3 corners = mesh.triangles[t];
      if (mirrored) std::swap(corners.y, corners.z);
      const bool corners_agree = same_corner(found.a, m, positions[corners.x]) &&
                                 same_corner(found.b, m, positions[corners.y]) &&
                                 same_corner(found.c, m, positions[corners.z]);
      if (!corners_agree) return fmt::format("triangle {} stands elsewhere", i);
      const scene::Material& material = scene.materials[mesh.materials[t]];
      const bool solid = material.transmission > 0 && material.thickness > 0;  // its inside is seen as well
      if (found.single_sided == (material.double_sided || solid)) return fmt::format("triangle {} has another back", i);
      if (found.transmissive && !(material.transmission > 0)) return fmt::format("triangle {} lets light through", i);
    }
  }
  return i == triangles.size() ? "" : "there are more triangles than the scene has";
}

}  // namespace crsh::test
