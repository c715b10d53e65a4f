#include "scene/device/storage.h"

#include "scene/deform.h"

namespace crsh::scene {
namespace {

uint32_t store(const Scene& scene, uint32_t mesh, Storage& out) {
  out.meshes.push_back({mesh, static_cast<uint32_t>(out.vertices), static_cast<uint32_t>(out.triangles)});
  out.vertices += scene.meshes[mesh].positions.size();
  out.triangles += scene.meshes[mesh].triangles.size();
  return static_cast<uint32_t>(out.meshes.size() - 1);
}

/// Meshes that every instance of them deforms: these have no use for one that does not.
std::vector<bool> always_deformed(const Scene& scene) {
  std::vector<bool> deformed(scene.meshes.size()), plain(scene.meshes.size());
  for (const Instance& instance : scene.instances) (deforms(scene, instance) ? deformed : plain)[instance.mesh] = true;
  for (size_t m = 0; m < deformed.size(); ++m) deformed[m] = deformed[m] && !plain[m];
  return deformed;
}

}  // namespace

Storage storage_of(const Scene& scene) {
  Storage out;
  const std::vector<bool> left_out = always_deformed(scene);
  std::vector<uint32_t> place(scene.meshes.size());
  for (uint32_t m = 0; m < scene.meshes.size(); ++m)
    if (!left_out[m]) place[m] = store(scene, m, out);
  out.first_own = static_cast<uint32_t>(out.meshes.size());
  for (const Instance& instance : scene.instances)
    out.of_instance.push_back(deforms(scene, instance) ? store(scene, instance.mesh, out) : place[instance.mesh]);
  return out;
}

}  // namespace crsh::scene
