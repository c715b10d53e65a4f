#include "scene/device/posed.h"

#include <algorithm>
#include <map>

#include "scene/deform.h"
#include "scene/device/upload.h"
#include "shared/limits.h"
#include "shared/scene.h"

namespace crsh::scene {
namespace {

static_assert(unskinned == shared::none);

/// The meshes that some instance deforms.
std::vector<bool> deformed_meshes(const Scene& scene) {
  std::vector<bool> out(scene.meshes.size());
  for (const Instance& instance : scene.instances)
    if (deforms(scene, instance)) out[instance.mesh] = true;
  return out;
}

/// Meshes at rest, one behind the other.
struct Rest {
  std::vector<shared::RestVertex> vertices;
  std::vector<shared::Influence> influences;
  std::vector<shared::Displacement> displacements;
  std::vector<uint32_t> first;  ///< of each mesh, where it is here

  void append(const Mesh& mesh) {
    for (size_t v = 0; v < mesh.positions.size(); ++v) {
      vertices.push_back({mesh.positions[v], uint32_t(influences.size()), mesh.normals[v],
                          uint32_t(displacements.size()),
                          mesh.tangents.empty() ? 0 : packed_tangent(mesh.tangents[v])});
      for (const Influence& i : mesh.influences.of(v)) influences.push_back({i.joint, i.weight});
      for (const Displacement& d : mesh.displacements.of(v))
        displacements.push_back({d.position, d.target, d.normal, d.tangent});
    }
  }
};

Rest rest_of(const Scene& scene) {
  Rest out;
  const std::vector<bool> deformed = deformed_meshes(scene);
  for (size_t m = 0; m < scene.meshes.size(); ++m) {
    out.first.push_back(uint32_t(out.vertices.size()));
    if (deformed[m]) out.append(scene.meshes[m]);
  }
  out.vertices.push_back({{}, uint32_t(out.influences.size()), {}, uint32_t(out.displacements.size()), 0});
  return out;
}

void upload_rest(gpu::Device& device, const Rest& rest, PosedTables& out) {
  out.rest = gpu::upload(device, rest.vertices, "vertices at rest");
  out.influences = gpu::upload(device, rest.influences, "influences of joints");
  out.displacements = gpu::upload(device, rest.displacements, "displacements by morph targets");
}

/// Where each skin's joints begin.
std::vector<uint32_t> first_joints(const Scene& scene) {
  std::vector<uint32_t> out;
  uint32_t next = 0;
  for (const Skin& skin : scene.skins) {
    out.push_back(next);
    next += uint32_t(skin.joints.size());
  }
  return out;
}

void upload_instances(gpu::Device& device, const Scene& scene, PosedTables& out) {
  const std::vector<uint32_t> joints = first_joints(scene);
  std::vector<shared::PosedInstance> instances;
  uint32_t weights = 0;
  for (uint32_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& one = scene.instances[i];
    if (!deforms(scene, one)) continue;
    const uint32_t joint_count = one.skin ? uint32_t(scene.skins[*one.skin].joints.size()) : 0;
    instances.push_back({one.skin ? joints[*one.skin] : 0, joint_count, weights, i});
    weights += scene.meshes[one.mesh].target_count;
    out.of_scene.push_back(i);
  }
  out.instances = gpu::upload(device, instances, "instances that deform");
  out.boxes.reserve(device, instances.size() * 6 * sizeof(uint32_t), "boxes of instances that deform");
}

void upload_vertices(gpu::Device& device, const Scene& scene, const Storage& storage, const Rest& rest,
                     PosedTables& out) {
  std::vector<shared::PosedVertex> vertices;
  for (uint32_t own = storage.first_own; own < storage.meshes.size(); ++own) {
    const uint32_t mesh = storage.meshes[own].mesh;
    for (uint32_t v = 0; v < scene.meshes[mesh].positions.size(); ++v)
      vertices.push_back({rest.first[mesh] + v, own - storage.first_own});
  }
  out.vertices = gpu::upload(device, vertices, "vertices that deform");
  out.vertex_count = uint32_t(vertices.size());
  out.first_vertex = storage.meshes[storage.first_own].first_vertex;
}

void upload_blocks(gpu::Device& device, const Scene& scene, PosedTables& out) {
  std::vector<glm::uvec4> blocks;
  uint32_t drawn = 0, posed = 0;
  for (const Instance& instance : scene.instances) {
    const auto count = uint32_t(scene.meshes[instance.mesh].triangles.size());
    for (uint32_t t = 0; deforms(scene, instance) && t < count; t += shared::block_triangles)
      blocks.emplace_back(posed, drawn + t, std::min(shared::block_triangles, count - t), 0);
    posed += deforms(scene, instance);
    drawn += count;
  }
  out.block_count = uint32_t(blocks.size());
  out.blocks = gpu::upload(device, blocks, "triangle blocks that deform");
}

glm::vec4 row(const glm::mat4& m, int i) { return {m[0][i], m[1][i], m[2][i], m[3][i]}; }

std::vector<glm::vec4> joint_rows(const GeometryPose& pose) {
  std::vector<glm::vec4> rows;
  for (const std::vector<glm::mat4>& skin : pose.joints)
    for (const glm::mat4& joint : skin)
      for (int i = 0; i < 3; ++i) rows.push_back(row(joint, i));
  return rows;
}

template <class T>
void write(gpu::Device& device, gpu::Buffer& target, const std::vector<T>& values, const char* name) {
  target.reserve(device, std::max<uint64_t>(values.size() * sizeof(T), 16), name);
  if (!values.empty()) gpu::upload_bytes(device, target, 0, values.data(), values.size() * sizeof(T));
}

/// Boxes that hold nothing.
std::vector<uint32_t> empty_boxes(size_t count) {
  std::vector<uint32_t> words;
  for (size_t i = 0; i < 6 * count; ++i) words.push_back(i % 6 < 3 ? 0xFFFFFFFFu : 0u);
  return words;
}

}  // namespace

PosedSizes posed_sizes(const Scene& scene) {
  PosedSizes sizes;
  const std::vector<bool> deformed = deformed_meshes(scene);
  for (size_t m = 0; m < scene.meshes.size(); ++m) {
    if (!deformed[m]) continue;
    sizes.rest += scene.meshes[m].positions.size() + 1;
    sizes.influences += scene.meshes[m].influences.items.size();
    sizes.displacements += scene.meshes[m].displacements.items.size();
  }
  for (const Skin& skin : scene.skins) sizes.joints += skin.joints.size();
  return sizes;
}

PosedTables upload_posed(gpu::Device& device, const Scene& scene, const Storage& storage) {
  PosedTables out;
  if (storage.first_own == storage.meshes.size()) return out;
  const Rest rest = rest_of(scene);
  upload_rest(device, rest, out);
  upload_instances(device, scene, out);
  upload_vertices(device, scene, storage, rest, out);
  upload_blocks(device, scene, out);
  return out;
}

void write_pose(gpu::Device& device, const Scene& scene, const GeometryPose& pose, PosedTables& tables) {
  if (tables.vertex_count == 0) return;
  std::vector<float> weights;
  for (const uint32_t i : tables.of_scene)
    for (uint32_t t = 0; t < scene.meshes[scene.instances[i].mesh].target_count; ++t)
      weights.push_back(t < pose.weights[i].size() ? pose.weights[i][t] : 0);
  write(device, tables.joints, joint_rows(pose), "joints");
  write(device, tables.weights, weights, "weights of morph targets");
  write(device, tables.boxes, empty_boxes(tables.of_scene.size()), "boxes of instances that deform");
}

void deform(gpu::Recorder& recorder, const GpuScene& scene) {
  const PosedTables& posed = scene.posed;
  const struct {
    uint32_t count;
    uint32_t first_vertex;
  } push{posed.vertex_count, posed.first_vertex};
  recorder.dispatch("scene/deform", posed.vertex_count, push,
                    {{"posed_vertices", posed.vertices},
                     {"posed_instances", posed.instances},
                     {"rest", posed.rest},
                     {"influences", posed.influences},
                     {"displacements", posed.displacements},
                     {"joints", posed.joints},
                     {"weights", posed.weights},
                     {"positions", scene.positions},
                     {"vertices", scene.vertices}});
}

void bound_posed(gpu::Recorder& recorder, const GpuScene& scene) {
  const PosedTables& posed = scene.posed;
  recorder.dispatch("scene/posed_boxes", posed.block_count, posed.block_count,
                    {{"blocks", posed.blocks}, {"triangle_spheres", scene.triangle_spheres}, {"boxes", posed.boxes}});
  recorder.dispatch("scene/posed_spheres", posed.block_count, posed.block_count,
                    {{"blocks", posed.blocks},
                     {"posed_instances", posed.instances},
                     {"triangle_spheres", scene.triangle_spheres},
                     {"boxes", posed.boxes},
                     {"object_spheres", scene.object_spheres}});
}

}  // namespace crsh::scene
