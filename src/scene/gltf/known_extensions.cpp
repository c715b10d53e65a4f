#include "scene/gltf/known_extensions.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

namespace crsh::scene {

namespace {

using nlohmann::json;

struct Known {
  std::string_view name;
  Support support;
};

constexpr Known known[] = {
    // Geometry and nodes.
    {"KHR_draco_mesh_compression", Support::done},
    {"KHR_mesh_quantization", Support::done},
    {"KHR_meshopt_compression", Support::done},
    {"EXT_meshopt_compression", Support::done},
    {"EXT_mesh_gpu_instancing", Support::done},
    {"EXT_mesh_primitive_restart", Support::done},
    {"KHR_animation_pointer", Support::done},
    {"KHR_lights_punctual", Support::done},
    {"KHR_node_visibility", Support::done},
    {"CESIUM_RTC", Support::changes_geometry},
    {"EXT_mesh_polygon", Support::changes_geometry},
    {"KHR_gaussian_splatting", Support::changes_geometry},
    {"KHR_gaussian_splatting_compression_spz_2", Support::changes_geometry},
    {"MPEG_mesh_linking", Support::changes_geometry},
    {"NEEDLE_progressive", Support::adds},
    {"EXT_mesh_primitive_edge_visibility", Support::adds},
    {"CESIUM_primitive_outline", Support::adds},
    // Materials.
    {"KHR_materials_anisotropy", Support::done},
    {"KHR_materials_clearcoat", Support::done},
    {"KHR_materials_diffuse_transmission", Support::done},
    {"KHR_materials_dispersion", Support::done},
    {"KHR_materials_emissive_strength", Support::done},
    {"KHR_materials_ior", Support::done},
    {"KHR_materials_iridescence", Support::done},
    {"KHR_materials_pbrSpecularGlossiness", Support::done},
    {"KHR_materials_sheen", Support::done},
    {"KHR_materials_specular", Support::done},
    {"KHR_materials_transmission", Support::done},
    {"KHR_materials_unlit", Support::done},
    {"KHR_materials_variants", Support::done},
    {"KHR_materials_volume", Support::done},
    {"KHR_texture_transform", Support::done},
    {"KHR_materials_common", Support::adds},
    {"KHR_materials_sss", Support::adds},
    {"KHR_materials_subsurface", Support::adds},
    {"KHR_materials_volume_scatter", Support::adds},
    {"KHR_technique_webgl", Support::adds},
    {"KHR_techniques_webgl", Support::adds},
    {"ADOBE_materials_clearcoat_specular", Support::adds},
    {"ADOBE_materials_clearcoat_tint", Support::adds},
    {"ADOBE_materials_thin_transparency", Support::adds},
    {"MSFT_packing_normalRoughnessMetallic", Support::adds},
    {"MSFT_packing_occlusionRoughnessMetallic", Support::adds},
    {"NV_materials_mdl", Support::adds},
    // Pictures and lights.
    {"EXT_texture_avif", Support::done},
    {"EXT_texture_webp", Support::done},
    {"KHR_texture_basisu", Support::done},
    {"MSFT_texture_dds", Support::adds},
    {"EXT_lights_ies", Support::adds},
    {"EXT_lights_image_based", Support::adds},
    {"KHR_environment_map", Support::adds},
    // What no picture shows.
    {"AGI_articulations", Support::harmless},
    {"AGI_stk_metadata", Support::harmless},
    {"EXT_feature_metadata", Support::harmless},
    {"EXT_instance_features", Support::harmless},
    {"EXT_mesh_features", Support::harmless},
    {"EXT_mesh_manifold", Support::harmless},
    {"EXT_structural_metadata", Support::harmless},
    {"FB_geometry_metadata", Support::harmless},
    {"GRIFFEL_bim_data", Support::harmless},
    {"KHR_audio_emitter", Support::harmless},
    {"KHR_audio_graph", Support::harmless},
    {"KHR_implicit_shapes", Support::harmless},
    {"KHR_interactivity", Support::harmless},
    {"KHR_node_hoverability", Support::harmless},
    {"KHR_node_selectability", Support::harmless},
    {"KHR_physics_rigid_bodies", Support::harmless},
    {"KHR_xmp", Support::harmless},
    {"KHR_xmp_json_ld", Support::harmless},
    {"MSFT_audio_emitter", Support::harmless},
    {"MSFT_lod", Support::harmless},  // the nodes in sight are the finest ones
    {"OMI_collider", Support::harmless},
    {"OMI_physics_body", Support::harmless},
    {"OMI_physics_shape", Support::harmless},
};

bool may_be_drawn(std::string_view name) {
  const std::optional<Support> support = support_of(name);
  return support && *support != Support::changes_geometry;
}

void add_list(const json& root, const char* key, std::set<std::string>& names) {
  const auto list = root.find(key);
  if (list == root.end()) return;
  if (!list->is_array()) throw Fault(std::string(key) + " is not an array");
  for (const json& name : *list) {
    if (!name.is_string()) throw Fault(std::string(key) + " holds something that is not a string");
    names.insert(name.get<std::string>());
  }
}

/// No deeper than parse_json() lets a file nest.
void add_standing(const json& value, std::set<std::string>& names) {
  if (value.is_array())
    for (const json& element : value) add_standing(element, names);
  if (!value.is_object()) return;
  for (const auto& [key, member] : value.items()) {
    if (key == "extensions" && member.is_object())
      for (const auto& extension : member.items()) names.insert(extension.key());
    if (key != "extras") add_standing(member, names);
  }
}

/// "A", "A and B", "A, B and C".
std::string listed(const std::vector<std::string>& names) {
  std::string out;
  for (size_t i = 0; i < names.size(); ++i)
    out += (i == 0 ? "" : i + 1 < names.size() ? ", " : " and ") + printable(names[i], 60);
  return out;
}

}  // namespace

std::optional<Support> support_of(std::string_view extension) {
  const auto* const found =
      std::find_if(std::begin(known), std::end(known), [extension](const Known& row) { return row.name == extension; });
  return found == std::end(known) ? std::nullopt : std::optional(found->support);
}

ExtensionNames extensions_in(const json& root) {
  ExtensionNames out;
  add_list(root, "extensionsRequired", out.required);
  out.used = out.required;
  add_list(root, "extensionsUsed", out.used);
  add_standing(root, out.used);
  return out;
}

void check_required(const ExtensionNames& names) {
  std::vector<std::string> missing;
  for (const std::string& name : names.required)
    if (!may_be_drawn(name)) missing.push_back(name);
  if (missing.empty()) return;
  throw NeedsExtensions("needs the extension" + std::string(missing.size() > 1 ? "s " : " ") + listed(missing) +
                        ", which crsh does not do");
}

void note_extensions(const ExtensionNames& names, Notes& notes) {
  for (const std::string& name : names.used) {
    const std::optional<Support> support = support_of(name);
    if (support == Support::done || support == Support::harmless) continue;
    notes.add("extension " + printable(name, 60) + (names.required.contains(name) ? ", which the file requires" : ""));
  }
}

}  // namespace crsh::scene
