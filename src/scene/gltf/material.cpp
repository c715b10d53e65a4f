#include "scene/gltf/material.h"

#include <algorithm>

#include "scene/gltf/checked.h"
#include "scene/gltf/extension.h"
#include "scene/gltf/textures.h"

namespace crsh::scene {

namespace {

constexpr float brightest = 1e15f;  // cd/m2; keeps products finite

float unit(float value) { return std::clamp(value, 0.0f, 1.0f); }

class MaterialReader {
 public:
  MaterialReader(TextureReader& textures, Notes& notes) : textures_(textures), notes_(notes) {}

  Material read(const tinygltf::Material& from, const std::string& where) {
    Material out;
    out.name = from.name;
    out.double_sided = from.doubleSided;
    for (int c = 0; c < 3; ++c)
      out.emissive[c] = std::max(finite(from.emissiveFactor[static_cast<size_t>(c)], where + ".emissiveFactor"), 0.0f);
    out.emissive_texture = textures_.use(from.emissiveTexture);
    read_metallic_roughness(out, from.pbrMetallicRoughness, where + ".pbrMetallicRoughness");
    read_extensions(out, from.extensions, where);
    note_what_is_left_out(from);
    return out;
  }

 private:
  void read_metallic_roughness(Material& out, const tinygltf::PbrMetallicRoughness& from, const std::string& where) {
    for (int c = 0; c < 4; ++c)
      out.base_colour[c] = unit(finite(from.baseColorFactor[static_cast<size_t>(c)], where + ".baseColorFactor"));
    out.metallic = unit(finite(from.metallicFactor, where + ".metallicFactor"));
    out.roughness = unit(finite(from.roughnessFactor, where + ".roughnessFactor"));
    out.base_colour_texture = textures_.use(from.baseColorTexture);
    out.metallic_roughness_texture = textures_.use(from.metallicRoughnessTexture);
  }

  void read_extensions(Material& out, const tinygltf::ExtensionMap& all, const std::string& where) {
    if (const auto strength = Extension::of(all, "KHR_materials_emissive_strength", where))
      out.emissive = glm::min(out.emissive * std::max(strength->number("emissiveStrength", 1), 0.0f), brightest);
    if (const auto ior = Extension::of(all, "KHR_materials_ior", where)) out.ior = refraction_of(*ior);
    if (const auto transmission = Extension::of(all, "KHR_materials_transmission", where)) {
      out.transmission = unit(transmission->number("transmissionFactor", 0));
      out.transmission_texture = textures_.use(*transmission, "transmissionTexture");
    }
    if (const auto volume = Extension::of(all, "KHR_materials_volume", where)) {
      out.thickness = std::max(volume->number("thicknessFactor", 0), 0.0f);
      if (volume->has("thicknessTexture")) notes_.add("thickness textures");
      if (volume->has("attenuationDistance") || volume->has("attenuationColor")) notes_.add("attenuation in volumes");
    }
  }

  /// 0 stands for an infinite index: all light is reflected (KHR_materials_ior, "Interaction with other extensions").
  static float refraction_of(const Extension& extension) {
    constexpr float infinite = 1e6f;
    const float ior = extension.number("ior", 1.5f);
    return ior == 0 ? infinite : std::max(ior, 1.0f);
  }

  void note_what_is_left_out(const tinygltf::Material& from) {
    if (from.normalTexture.index >= 0) notes_.add("normal maps");
    if (from.occlusionTexture.index >= 0) notes_.add("occlusion maps");
    if (from.alphaMode == "MASK" || from.alphaMode == "BLEND")
      notes_.add("alphaMode " + from.alphaMode + " (drawn opaque)");
  }

  TextureReader& textures_;
  Notes& notes_;
};

}  // namespace

void read_materials(Document& document, const std::set<uint32_t>& used, Scene& scene, Notes& notes) {
  const std::vector<tinygltf::Material>& materials = document.model().materials;
  scene.materials.resize(materials.size() + 1);
  TextureReader textures(document, scene, notes);
  MaterialReader reader(textures, notes);
  for (const uint32_t index : used)
    if (index < materials.size()) scene.materials[index] = reader.read(materials[index], place("materials", index));
}

}  // namespace crsh::scene
