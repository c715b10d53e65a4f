#include "scene/gltf/material.h"

#include <algorithm>

#include "scene/gltf/checked.h"
#include "scene/gltf/extension.h"
#include "scene/gltf/textures.h"

namespace crsh::scene {

namespace {

constexpr float brightest = 1e15f;  // cd/m2; keeps products finite

float unit(float value) { return std::clamp(value, 0.0f, 1.0f); }

glm::vec3 colour_of(const Extension& from, const std::string& key, float otherwise) {
  const auto colour = from.numbers<3>(key);
  return colour ? glm::max(glm::vec3((*colour)[0], (*colour)[1], (*colour)[2]), 0.0f) : glm::vec3(otherwise);
}

float not_negative(const Extension& from, const std::string& key, float otherwise) {
  return std::max(from.number(key, otherwise), 0.0f);
}

AlphaMode alpha_mode_of(const std::string& name) {
  return name == "MASK" ? AlphaMode::mask : name == "BLEND" ? AlphaMode::blend : AlphaMode::opaque;
}

class MaterialReader {
 public:
  explicit MaterialReader(TextureReader& textures) : textures_(textures) {}

  Material read(const tinygltf::Material& from, const std::string& where) {
    Material out;
    out.name = from.name;
    out.double_sided = from.doubleSided;
    for (int c = 0; c < 3; ++c)
      out.emissive_factor[c] =
          std::max(finite(from.emissiveFactor[static_cast<size_t>(c)], where + ".emissiveFactor"), 0.0f);
    out.emissive = out.emissive_factor;
    out.texture(Slot::emissive) = textures_.use(from.emissiveTexture, where + ".emissiveTexture");
    out.alpha_mode = alpha_mode_of(from.alphaMode);
    out.alpha_cutoff = finite(from.alphaCutoff, where + ".alphaCutoff");
    read_details(out, from, where);
    read_metallic_roughness(out, from.pbrMetallicRoughness, where + ".pbrMetallicRoughness");
    read_body(out, from.extensions, where);
    read_lobes(out, from.extensions, where);
    read_glossiness(out, from.extensions, where);
    return out;
  }

 private:
  void read_details(Material& out, const tinygltf::Material& from, const std::string& where) {
    out.texture(Slot::normal) = textures_.use(from.normalTexture, where + ".normalTexture");
    out.normal_scale = finite(from.normalTexture.scale, where + ".normalTexture.scale");
    out.texture(Slot::occlusion) = textures_.use(from.occlusionTexture, where + ".occlusionTexture");
    out.occlusion_strength = unit(finite(from.occlusionTexture.strength, where + ".occlusionTexture.strength"));
  }

  void read_metallic_roughness(Material& out, const tinygltf::PbrMetallicRoughness& from, const std::string& where) {
    for (int c = 0; c < 4; ++c)
      out.base_colour[c] = unit(finite(from.baseColorFactor[static_cast<size_t>(c)], where + ".baseColorFactor"));
    out.metallic = unit(finite(from.metallicFactor, where + ".metallicFactor"));
    out.roughness = unit(finite(from.roughnessFactor, where + ".roughnessFactor"));
    out.texture(Slot::base_colour) = textures_.use(from.baseColorTexture, where + ".baseColorTexture");
    out.texture(Slot::metallic_roughness) =
        textures_.use(from.metallicRoughnessTexture, where + ".metallicRoughnessTexture");
  }

  void set_texture(Material& out, Slot slot, const Extension& from, const std::string& key) {
    out.texture(slot) = textures_.use(from, key);
  }

  /// Emission, and what goes through the material.
  void read_body(Material& out, const tinygltf::ExtensionMap& all, const std::string& where) {
    out.unlit = Extension::of(all, "KHR_materials_unlit", where).has_value();
    if (const auto strength = Extension::of(all, "KHR_materials_emissive_strength", where)) {
      out.emissive_strength = not_negative(*strength, "emissiveStrength", 1);
      out.emissive = glm::min(out.emissive_factor * out.emissive_strength, brightest);
    }
    if (const auto ior = Extension::of(all, "KHR_materials_ior", where)) out.ior = refraction_of(*ior);
    if (const auto transmission = Extension::of(all, "KHR_materials_transmission", where)) {
      out.transmission = unit(transmission->number("transmissionFactor", 0));
      set_texture(out, Slot::transmission, *transmission, "transmissionTexture");
    }
    if (const auto volume = Extension::of(all, "KHR_materials_volume", where)) {
      out.thickness = not_negative(*volume, "thicknessFactor", 0);
      set_texture(out, Slot::thickness, *volume, "thicknessTexture");
      out.attenuation.colour = glm::min(colour_of(*volume, "attenuationColor", 1), 1.0f);
      const float distance = volume->number("attenuationDistance", out.attenuation.distance);
      if (distance > 0) out.attenuation.distance = distance;
    }
    if (const auto dispersion = Extension::of(all, "KHR_materials_dispersion", where))
      out.dispersion = not_negative(*dispersion, "dispersion", 0);
    if (const auto through = Extension::of(all, "KHR_materials_diffuse_transmission", where)) {
      out.diffuse_transmission = {unit(through->number("diffuseTransmissionFactor", 0)),
                                  colour_of(*through, "diffuseTransmissionColorFactor", 1)};
      set_texture(out, Slot::diffuse_transmission, *through, "diffuseTransmissionTexture");
      set_texture(out, Slot::diffuse_transmission_colour, *through, "diffuseTransmissionColorTexture");
    }
  }

  /// What is reflected besides.
  void read_lobes(Material& out, const tinygltf::ExtensionMap& all, const std::string& where) {
    if (const auto specular = Extension::of(all, "KHR_materials_specular", where)) {
      out.specular = {unit(specular->number("specularFactor", 1)), colour_of(*specular, "specularColorFactor", 1)};
      set_texture(out, Slot::specular, *specular, "specularTexture");
      set_texture(out, Slot::specular_colour, *specular, "specularColorTexture");
    }
    if (const auto coat = Extension::of(all, "KHR_materials_clearcoat", where)) read_clearcoat(out, *coat);
    if (const auto sheen = Extension::of(all, "KHR_materials_sheen", where)) {
      out.sheen = {colour_of(*sheen, "sheenColorFactor", 0), unit(sheen->number("sheenRoughnessFactor", 0))};
      set_texture(out, Slot::sheen_colour, *sheen, "sheenColorTexture");
      set_texture(out, Slot::sheen_roughness, *sheen, "sheenRoughnessTexture");
    }
    if (const auto film = Extension::of(all, "KHR_materials_iridescence", where)) {
      out.iridescence = {unit(film->number("iridescenceFactor", 0)),
                         std::max(film->number("iridescenceIor", 1.3f), 1.0f),
                         not_negative(*film, "iridescenceThicknessMinimum", 100),
                         not_negative(*film, "iridescenceThicknessMaximum", 400)};
      set_texture(out, Slot::iridescence, *film, "iridescenceTexture");
      set_texture(out, Slot::iridescence_thickness, *film, "iridescenceThicknessTexture");
    }
    if (const auto anisotropy = Extension::of(all, "KHR_materials_anisotropy", where)) {
      out.anisotropy = {unit(anisotropy->number("anisotropyStrength", 0)), anisotropy->number("anisotropyRotation", 0)};
      set_texture(out, Slot::anisotropy, *anisotropy, "anisotropyTexture");
    }
  }

  void read_clearcoat(Material& out, const Extension& coat) {
    out.clearcoat = {unit(coat.number("clearcoatFactor", 0)), unit(coat.number("clearcoatRoughnessFactor", 0)), 1};
    set_texture(out, Slot::clearcoat, coat, "clearcoatTexture");
    set_texture(out, Slot::clearcoat_roughness, coat, "clearcoatRoughnessTexture");
    set_texture(out, Slot::clearcoat_normal, coat, "clearcoatNormalTexture");
    if (const auto map = coat.object("clearcoatNormalTexture")) out.clearcoat.normal_scale = map->number("scale", 1);
  }

  /// Archived; where a file has both, its own metal and roughness are the fallback.
  void read_glossiness(Material& out, const tinygltf::ExtensionMap& all, const std::string& where) {
    const auto from = Extension::of(all, "KHR_materials_pbrSpecularGlossiness", where);
    if (!from) return;
    const auto diffuse = from->numbers<4>("diffuseFactor").value_or(std::array<float, 4>{1, 1, 1, 1});
    for (int c = 0; c < 4; ++c) out.base_colour[c] = unit(diffuse[static_cast<size_t>(c)]);
    out.specular_glossiness = {glm::min(colour_of(*from, "specularFactor", 1), 1.0f),
                               unit(from->number("glossinessFactor", 1))};
    out.metallic = 0;
    out.roughness = 1 - out.specular_glossiness->glossiness;
    out.texture(Slot::metallic_roughness) = {};
    set_texture(out, Slot::base_colour, *from, "diffuseTexture");
    set_texture(out, Slot::specular_glossiness, *from, "specularGlossinessTexture");
  }

  /// 0 stands for an infinite index: all light is reflected (KHR_materials_ior, "Interaction with other extensions").
  static float refraction_of(const Extension& extension) {
    constexpr float infinite = 1e6f;
    const float ior = extension.number("ior", 1.5f);
    return ior == 0 ? infinite : std::max(ior, 1.0f);
  }

  TextureReader& textures_;
};

}  // namespace

/// Twice: what is read first tells the textures which images are drawn.
void read_materials(Document& document, const std::set<uint32_t>& used, Scene& scene, Notes& notes) {
  const std::vector<tinygltf::Material>& materials = document.model().materials;
  scene.materials.resize(materials.size() + 1);
  TextureReader textures(document, scene, notes);
  const auto read_all = [&] {
    MaterialReader reader(textures);
    for (const uint32_t index : used)
      if (index < materials.size()) scene.materials[index] = reader.read(materials[index], place("materials", index));
  };
  read_all();
  textures.start_reading();
  read_all();
}

}  // namespace crsh::scene
