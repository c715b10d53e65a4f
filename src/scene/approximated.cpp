#include "scene/approximated.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace crsh::scene {
namespace {

std::set<uint32_t> materials_in_use(const Scene& scene) {
  std::set<uint32_t> used;
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    used.insert(mesh.materials.begin(), mesh.materials.end());
  }
  return used;
}

/// Only the sharp part of a reflection is traced (shaders/lib/fresnel.glsl, reflection_weight). Of what is wholly rough
/// and no metal, the reflection is so faint and wide that leaving it out is no picture of a mirror.
bool reflects_too_sharply(const Material& material) {
  if (material.unlit) return false;
  const bool coat = material.clearcoat.factor > 0 && material.clearcoat.roughness > 0;
  return coat || (material.roughness > 0 && (material.roughness < 1 || material.metallic > 0));
}

/// Refraction knows no roughness.
bool is_too_clear(const Material& material) { return material.transmission > 0 && material.roughness > 0; }

bool disperses(const Material& material) { return material.dispersion > 0 && material.thickness > 0; }

/// Shadow rays know no distances inside (device_materials.cpp, half_absorbed).
bool shadows_by_thickness(const Material& material) {
  return material.transmission > 0 && material.thickness > 0 && material.attenuation != Attenuation{};
}

/// A volume behind diffuse transmission scatters light.
bool scatters(const Material& material) { return material.diffuse_transmission.factor > 0 && material.thickness > 0; }

/// They dim light from everywhere, which nothing casts.
bool has_occlusion(const Material& material) { return material.texture(Slot::occlusion).texture.has_value(); }

bool has_sheen(const Material& material) { return material.sheen.colour != glm::vec3(0); }

}  // namespace

std::vector<std::string> approximated(const Scene& scene) {
  const std::set<uint32_t> used = materials_in_use(scene);
  std::vector<std::string> clauses;
  const auto add = [&](const char* clause, bool (*applies)(const Material&)) {
    const auto count = std::ranges::count_if(used, [&](uint32_t index) { return applies(scene.materials[index]); });
    if (count) clauses.push_back(fmt::format("{} ({} of {} materials)", clause, count, used.size()));
  };
  add("rough reflection, drawn as a sharp mirror dimmed by (1 - roughness)^2", reflects_too_sharply);
  add("rough glass, drawn clear", is_too_clear);
  add("dispersion, all colours bent by the one index of refraction", disperses);
  add("shadows of coloured solids, by the thickness that the file gives", shadows_by_thickness);
  add("light scattered inside diffuse transmission, drawn as through a thin sheet", scatters);
  add("sheen, seen by lamps' light alone", has_sheen);
  add("occlusion maps, which lamps' light does not show", has_occlusion);
  return clauses;
}

}  // namespace crsh::scene
