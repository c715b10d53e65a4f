#include "scene/device/upload.h"

#include <fmt/format.h>

#include <algorithm>

#include "crsh/error.h"
#include "scene/deform.h"
#include "scene/device/device_materials.h"
#include "scene/device/sheers.h"
#include "scene/device/storage.h"
#include "scene/packed.h"
#include "shared/limits.h"
#include "shared/scene.h"

namespace crsh::scene {
namespace {

/// One line where there are more than `most`.
void require_at_most(const gpu::Device& device, const Scene& scene, uint64_t count, uint64_t most, const char* what) {
  if (count <= most) return;
  throw UserError(fmt::format("{}: {} {}, and {} holds at most {} in one buffer", scene.path.string(), count, what,
                              device.info().name, most),
                  Mend::smaller_scene_or_other_device);
}

/// One line where `count` elements of `size` bytes do not fit a binding.
void require_binding(const gpu::Device& device, const Scene& scene, uint64_t count, uint64_t size, const char* what) {
  require_at_most(device, scene, count, device.limits().max_binding / size, what);
}

/// The same where it is also read as a texel buffer, `words` texels an element.
void require_texels(const gpu::Device& device, const Scene& scene, uint64_t count, uint64_t words, const char* what) {
  require_at_most(device, scene, count, std::min(device.limits().max_binding / 16, device.limits().max_texels) / words,
                  what);
}

/// Of what deforms.
void require_posed(const gpu::Device& device, const Scene& scene) {
  const PosedSizes sizes = posed_sizes(scene);
  require_binding(device, scene, sizes.rest, sizeof(shared::RestVertex), "vertices that deform");
  require_binding(device, scene, sizes.influences, sizeof(shared::Influence), "influences of joints");
  require_binding(device, scene, sizes.displacements, sizeof(shared::Displacement), "displacements by morph targets");
  require_binding(device, scene, sizes.joints, 3 * sizeof(glm::vec4), "joints");
}

void require_bindings(const gpu::Device& device, const Scene& scene, const Storage& storage) {
  require_texels(device, scene, storage.vertices, sizeof(shared::Vertex) / 16, "vertices");
  require_texels(device, scene, storage.triangles, sizeof(shared::StoredTriangle) / 16, "triangles");
  require_posed(device, scene);
  const uint64_t max_drawn = std::min(device.limits().max_binding / sizeof(glm::vec4), device.limits().max_texels);
  require_at_most(device, scene, scene.triangle_count(), max_drawn, "drawn triangles");
  require_binding(device, scene, scene.instances.size(), sizeof(shared::Instance), "objects");
}

glm::vec2 uv_of(const Mesh& mesh, size_t set, size_t vertex) {
  return mesh.uv[set].empty() ? glm::vec2(0) : mesh.uv[set][vertex];
}

/// How each set of texture coordinates runs over the triangle (shared::StoredTriangle).
glm::uvec3 uv_metrics(const Mesh& mesh, size_t triangle) {
  const glm::uvec3 corners = mesh.triangles[triangle];
  const auto position = [&](uint32_t corner) { return glm::dvec3(mesh.positions[corner]); };
  const std::array<glm::dvec3, 3> at = {position(corners.x), position(corners.y), position(corners.z)};
  glm::uvec3 out(0);
  for (size_t set = 0; set < uv_sets; ++set)
    if (!mesh.uv[set].empty())
      out[int(set)] = packed_metric(
          uv_metric(at, {uv_of(mesh, set, corners.x), uv_of(mesh, set, corners.y), uv_of(mesh, set, corners.z)}));
  return out;
}

shared::Vertex device_vertex(const Mesh& mesh, size_t v) {
  return {mesh.normals[v],
          mesh.tangents.empty() ? 0 : packed_tangent(mesh.tangents[v]),
          mesh.colours[v],
          {uv_of(mesh, 0, v), uv_of(mesh, 1, v), uv_of(mesh, 2, v)}};
}

void upload_meshes(gpu::Device& device, const Scene& scene, const Storage& storage, const Sheers& sheers,
                   GpuScene& out) {
  std::vector<glm::vec3> positions;
  std::vector<shared::Vertex> vertices;
  std::vector<shared::StoredTriangle> triangles;
  for (const StoredMesh& stored : storage.meshes) {
    const Mesh& mesh = scene.meshes[stored.mesh];
    const glm::uvec3 base(stored.first_vertex);
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
      const uint32_t sheer = sheers.of_stored[triangles.size()];
      const uint32_t flag = sheer == shared::none ? 0 : shared::triangle_sheer;
      triangles.push_back(
          {mesh.triangles[t] + base, flagged_material(scene, mesh.materials[t]) | flag, uv_metrics(mesh, t), sheer});
    }
    positions.insert(positions.end(), mesh.positions.begin(), mesh.positions.end());
    for (size_t v = 0; v < mesh.positions.size(); ++v) vertices.push_back(device_vertex(mesh, v));
  }
  out.positions = gpu::upload(device, positions, "positions");
  out.vertices = gpu::upload(device, vertices, "vertices");
  out.triangles = gpu::upload(device, triangles, "triangles");
}

/// Uploads the drawn triangles, those of a mesh once for each instance, and the blocks in which the top level of the
/// traversal takes them.
void upload_instances(gpu::Device& device, const Scene& scene, const Storage& storage, GpuScene& out) {
  std::vector<shared::Source> sources;
  std::vector<glm::uvec4> blocks;
  for (uint32_t i = 0; i < scene.instances.size(); ++i) {
    const StoredMesh& stored = storage.meshes[storage.of_instance[i]];
    const uint32_t drawn = uint32_t(sources.size()), count = uint32_t(scene.meshes[stored.mesh].triangles.size());
    for (uint32_t t = 0; t < count; ++t) sources.push_back({i, stored.first_triangle + t});
    for (uint32_t t = 0; t < count; t += shared::block_triangles)
      blocks.emplace_back(i, drawn + t, std::min(shared::block_triangles, count - t), 0);
  }
  out.triangle_count = uint32_t(sources.size());
  out.instance_count = uint32_t(scene.instances.size());
  out.block_count = uint32_t(blocks.size());
  out.sources = gpu::upload(device, sources, "sources");
  out.blocks = gpu::upload(device, blocks, "triangle blocks");
}

/// After the instances, whose triangles it numbers.
void upload_sheers(gpu::Device& device, const Scene& scene, const Storage& storage, const Sheers& sheers,
                   GpuScene& out) {
  require_texels(device, scene, sheers.records.size(), sizeof(shared::Sheer) / 16, "triangles with alpha");
  std::vector<uint32_t> numbers;
  for (size_t i = 0; i < scene.instances.size() && sheers.pages; ++i) {
    const StoredMesh& stored = storage.meshes[storage.of_instance[i]];
    for (size_t t = 0; t < scene.meshes[stored.mesh].triangles.size(); ++t) {
      const uint32_t number = sheers.of_stored[stored.first_triangle + t];
      numbers.push_back(number == shared::none ? 0 : number);
    }
  }
  out.sheers = gpu::upload(device, sheers.records, "triangles with alpha");
  out.sheer_numbers = gpu::upload(device, numbers, "numbers of triangles with alpha");
  out.sheer_pages = sheers.pages;
}

DeviceMaterials materials_for(const gpu::Device& device, const Scene& scene) {
  const gpu::Limits& limits = device.limits();
  return device_materials(scene, std::min(limits.max_binding / sizeof(uint32_t), limits.max_texels));
}

void upload_materials(gpu::Device& device, const Scene& scene, DeviceMaterials& all, GpuScene& out) {
  require_texels(device, scene, all.textures.size(), 1, "textures");
  require_texels(device, scene, all.materials.size(), 6, "materials");
  out.materials = gpu::upload(device, all.materials, "materials");
  out.given_materials = std::move(all.materials);
  out.textures = gpu::upload(device, all.textures, "textures");
  out.texture_uses = gpu::upload(device, all.uses, "texture uses");
  out.lobes = gpu::upload(device, all.lobes, "lobes");
  out.has_lobes = !all.lobes.empty();
  for (size_t page = 0; page < texel_page_count; ++page)
    out.texels[page] = gpu::upload(device, all.texels.pages[page], "texels");
  out.notes = std::move(all.texels.notes);
}

/// Makes room for what animate() fills in.
void reserve_moved(gpu::Device& device, GpuScene& out) {
  const uint64_t corners = std::max(out.triangle_count, 1u) * uint64_t(sizeof(glm::vec4));
  out.corner_a.reserve(device, corners, "corners a");
  out.corner_b.reserve(device, corners, "corners b");
  out.corner_c.reserve(device, corners, "corners c");
  out.triangle_spheres.reserve(device, corners, "triangle spheres");
  const uint64_t instances = std::max(out.instance_count, 1u);
  out.instances.reserve(device, instances * sizeof(shared::Instance), "instances");
  out.object_spheres.reserve(device, instances * sizeof(glm::vec4), "object spheres");
}

/// In the order of shaders/scene/tables.glsl. After all its buffers have been made.
gpu::BufferSet tables_of(gpu::Device& device, const GpuScene& scene) {
  using enum gpu::ReadAs;
  const std::array<gpu::BufferSet::Member, 11 + texel_page_count> members = {{
      {"corner_a", scene.corner_a, texels_rgba32u},
      {"corner_b", scene.corner_b, texels_rgba32u},
      {"corner_c", scene.corner_c, texels_rgba32u},
      {"triangles", scene.triangles, texels_rgba32u},
      {"vertices", scene.vertices, texels_rgba32u},
      {"instances", scene.instances},
      {"materials", scene.materials, texels_rgba32u},
      {"textures", scene.textures, texels_rgba32u},
      {"texture_uses", scene.texture_uses, texels_rgba32u},
      {"lobes", scene.lobes, texels_rgba32u},
      {"texels0", scene.texels[0], texels_r32u},
      {"texels1", scene.texels[1], texels_r32u},
      {"texels2", scene.texels[2], texels_r32u},
      {"texels3", scene.texels[3], texels_r32u},
      {"sheers", scene.sheers, texels_rgba32u},
  }};
  return {device, members};
}

/// In the order of shaders/intersection/sheer_tables.glsl.
gpu::BufferSet sheer_tables_of(gpu::Device& device, const GpuScene& scene) {
  using enum gpu::ReadAs;
  const std::array<gpu::BufferSet::Member, 3 + texel_page_count> members = {{
      {"sheer_numbers", scene.sheer_numbers, texels_r32u},
      {"sheers", scene.sheers, texels_rgba32u},
      {"textures", scene.textures, texels_rgba32u},
      {"texels0", scene.texels[0], texels_r32u},
      {"texels1", scene.texels[1], texels_r32u},
      {"texels2", scene.texels[2], texels_r32u},
      {"texels3", scene.texels[3], texels_r32u},
  }};
  return {device, members};
}

glm::vec4 row(const glm::mat4& m, int i) { return {m[0][i], m[1][i], m[2][i], m[3][i]}; }

/// Normals are turned by the matrix's cofactors, which exist even where it has no inverse. For a mirrored instance they
/// are negated, so that normals stay on the side that its swapped corners face.
shared::Instance device_instance(const glm::mat4& m) {
  const glm::vec3 x(m[0]), y(m[1]), z(m[2]);
  const bool mirrored = glm::dot(glm::dvec3(x), glm::cross(glm::dvec3(y), glm::dvec3(z))) < 0;
  const float sign = mirrored ? -1.0f : 1.0f;
  const float largest = std::max({glm::length(x), glm::length(y), glm::length(z), 1e-30f});
  const glm::vec3 unit_x = x / largest, unit_y = y / largest, unit_z = z / largest;
  const glm::mat3 cofactors(glm::cross(unit_y, unit_z) * sign, glm::cross(unit_z, unit_x) * sign,
                            glm::cross(unit_x, unit_y) * sign);
  const glm::mat3 rows = glm::transpose(cofactors);
  return {row(m, 0),
          row(m, 1),
          row(m, 2),
          glm::vec4(rows[0], mirrored ? 1.0f : 0.0f),
          glm::vec4(rows[1], 0),
          glm::vec4(rows[2], 0)};
}

template <class T>
void write(gpu::Device& device, gpu::Buffer& target, const std::vector<T>& values) {
  if (!values.empty()) gpu::upload_bytes(device, target, 0, values.data(), values.size() * sizeof(T));
}

/// The instance's sphere; of one that deforms nothing yet, because bound_posed() finds it, but its bounds are included.
glm::vec4 move_sphere(GpuScene& target, const Scene& scene, const Pose& pose, uint32_t i) {
  const bool hidden = !pose.hidden.empty() && pose.hidden[i];
  if (deforms(scene, scene.instances[i])) {
    if (!hidden) target.bounds.include(posed_bounds(scene, pose, i));
    return glm::vec4(0);
  }
  const Sphere sphere = transformed_sphere(scene.meshes[scene.instances[i].mesh], pose.instances[i]);
  if (sphere.radius > 0 && !hidden) target.bounds.include(sphere);
  return {sphere.centre, sphere.radius};
}

void move_objects(gpu::Device& device, GpuScene& target, const Scene& scene, const Pose& pose) {
  std::vector<shared::Instance> instances;
  std::vector<glm::vec4> spheres;
  target.bounds = {};
  for (uint32_t i = 0; i < scene.instances.size(); ++i) {
    instances.push_back(device_instance(pose.instances[i]));
    if (scene.instances[i].skin) instances.back().normal0.w = is_mirrored(scene, pose, i) ? 1.0f : 0.0f;
    spheres.push_back(move_sphere(target, scene, pose, i));
  }
  write(device, target.instances, instances);
  write(device, target.object_spheres, spheres);
}

void move_lights(gpu::Device& device, GpuScene& target, const Scene& scene, const Pose& pose, const LightRig& rig) {
  const std::vector<shared::Light> lights = world_lights(scene, pose, rig, target.bounds);
  require_binding(device, scene, lights.size(), sizeof(shared::Light), "lights");
  target.light_count = uint32_t(lights.size());
  target.lights.reserve(device, std::max(lights.size(), size_t(1)) * sizeof(shared::Light), "lights");
  write(device, target.lights, lights);
}

/// Gives materials what animations have made of them; what they have changed before is as the file has it again.
void change_materials(gpu::Device& device, GpuScene& target, const Scene& scene, const Pose& pose) {
  const auto& changes = pose.changes.materials;
  if (changes.empty() && !target.materials_changed) return;
  std::vector<shared::Material> materials = target.given_materials;
  for (const auto& [index, material] : changes) set_factors(scene, material, materials[index]);
  write(device, target.materials, materials);
  target.materials_changed = !changes.empty();
}

}  // namespace

std::vector<std::pair<uint32_t, uint32_t>> GpuScene::sheer_constants() const {
  if (sheer_pages == 0) return {};
  return {{shared::constant_sheer_pages, sheer_pages}};
}

GpuScene upload(gpu::Device& device, const Scene& scene) {
  const Storage storage = storage_of(scene);
  require_bindings(device, scene, storage);
  GpuScene out;
  DeviceMaterials materials = materials_for(device, scene);
  const Sheers sheers = sheers_of(scene, storage, materials);
  upload_meshes(device, scene, storage, sheers, out);
  upload_instances(device, scene, storage, out);
  upload_sheers(device, scene, storage, sheers, out);
  out.posed = upload_posed(device, scene, storage);
  upload_materials(device, scene, materials, out);
  reserve_moved(device, out);
  out.tables = tables_of(device, out);
  out.sheer_tables = sheer_tables_of(device, out);
  return out;
}

void animate(gpu::Recorder& recorder, GpuScene& target, const Scene& scene, const Pose& pose, const LightRig& lights) {
  recorder.submit();  // first, because recorded commands may still read what is overwritten now
  move_objects(recorder.device(), target, scene, pose);
  move_lights(recorder.device(), target, scene, pose, lights);
  change_materials(recorder.device(), target, scene, pose);
  write_pose(recorder.device(), scene, pose, target.posed);
  deform(recorder, target);
  const uint32_t push = target.triangle_count;
  recorder.dispatch("scene/animate", target.triangle_count, push,
                    {{"sources", target.sources},
                     {"triangles", target.triangles},
                     {"positions", target.positions},
                     {"instances", target.instances},
                     {"corner_a", target.corner_a},
                     {"corner_b", target.corner_b},
                     {"corner_c", target.corner_c},
                     {"triangle_spheres", target.triangle_spheres}});
  bound_posed(recorder, target);
}

}  // namespace crsh::scene
