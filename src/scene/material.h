#pragma once
// Textures and materials, as loaded: glTF 2.0's metallic-roughness material and its extensions.

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace crsh::scene {

/// Eight bits a channel, RGBA, rows from the top.
struct Image {
  uint32_t width = 0, height = 0;
  std::vector<uint8_t> rgba;
};

enum class Wrap : uint32_t { repeat = 0, clamp = 1, mirror = 2 };

/// How a texture that is seen smaller than it is gets filtered: not at all, or by mip levels.
enum class Mips { none, nearest, linear };

struct Texture {
  uint32_t image = 0;
  Wrap wrap_s = Wrap::repeat, wrap_t = Wrap::repeat;
  bool nearest = false;           ///< seen larger than it is: the nearest texel, else four weighted
  bool nearest_in_level = false;  ///< the same where it is seen smaller
  Mips mips = Mips::linear;
};

/// KHR_texture_transform: uv' = offset + R(rotation) * scale * uv.
struct TextureTransform {
  glm::vec2 offset{0}, scale{1};
  float rotation = 0;  ///< radians, counter-clockwise in a picture whose v goes down
  bool operator==(const TextureTransform&) const = default;
};

/// A texture, the set of coordinates with which it is used, and how these are transformed.
struct TextureUse {
  std::optional<uint32_t> texture;
  uint32_t texcoord = 0;  ///< one of Mesh::uv
  TextureTransform transform;
};

enum class AlphaMode { opaque, mask, blend };

/// What a material may have a texture for, in the order of shared/scene.h's bits.
enum class Slot : uint32_t {
  base_colour,
  metallic_roughness,
  emissive,
  transmission,
  normal,
  occlusion,
  specular,
  specular_colour,
  clearcoat,
  clearcoat_roughness,
  clearcoat_normal,
  sheen_colour,
  sheen_roughness,
  iridescence,
  iridescence_thickness,
  anisotropy,
  thickness,
  diffuse_transmission,
  diffuse_transmission_colour,
  specular_glossiness,
};
inline constexpr size_t slot_count = 20;

/// Whether a slot's RGB is coded in sRGB.
[[nodiscard]] constexpr bool is_srgb(Slot slot) {
  using enum Slot;
  return slot == base_colour || slot == emissive || slot == specular_colour || slot == sheen_colour ||
         slot == diffuse_transmission_colour || slot == specular_glossiness;
}

// KHR_materials_*: each as its specification has it, and by default without effect.

struct Specular {
  float factor = 1;
  glm::vec3 colour{1};
  bool operator==(const Specular&) const = default;
};

struct Clearcoat {
  float factor = 0, roughness = 0, normal_scale = 1;
  bool operator==(const Clearcoat&) const = default;
};

struct Sheen {
  glm::vec3 colour{0};
  float roughness = 0;
  bool operator==(const Sheen&) const = default;
};

struct Iridescence {
  float factor = 0, ior = 1.3f;
  float min_thickness = 100, max_thickness = 400;  ///< nanometres
  bool operator==(const Iridescence&) const = default;
};

struct Anisotropy {
  float strength = 0;
  float rotation = 0;  ///< radians from the tangent, counter-clockwise
  bool operator==(const Anisotropy&) const = default;
};

/// What a solid takes away: `colour` is left of white light after `distance` metres.
struct Attenuation {
  glm::vec3 colour{1};
  float distance = std::numeric_limits<float>::infinity();
  bool operator==(const Attenuation&) const = default;
};

struct DiffuseTransmission {
  float factor = 0;
  glm::vec3 colour{1};
  bool operator==(const DiffuseTransmission&) const = default;
};

/// KHR_materials_pbrSpecularGlossiness (archived). Its diffuse factor is Material::base_colour.
struct SpecularGlossiness {
  glm::vec3 specular{1};
  float glossiness = 1;
  bool operator==(const SpecularGlossiness&) const = default;
};

struct Material {
  std::string name;
  glm::vec4 base_colour{1};
  glm::vec3 emissive{0};  ///< factor times KHR_materials_emissive_strength
  glm::vec3 emissive_factor{0};
  float emissive_strength = 1;
  float metallic = 1, roughness = 1;
  float transmission = 0, ior = 1.5f, thickness = 0;
  float normal_scale = 1, occlusion_strength = 1;
  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;
  bool double_sided = false, unlit = false;
  bool may_transmit = false;  ///< an animation may let light through it
  float dispersion = 0;       ///< KHR_materials_dispersion: 20 / Abbe number
  Specular specular;
  Clearcoat clearcoat;
  Sheen sheen;
  Iridescence iridescence;
  Anisotropy anisotropy;
  Attenuation attenuation;
  DiffuseTransmission diffuse_transmission;
  std::optional<SpecularGlossiness> specular_glossiness;  ///< in place of metal and roughness
  std::array<TextureUse, slot_count> textures;            ///< by Slot

  [[nodiscard]] const TextureUse& texture(Slot slot) const { return textures[size_t(slot)]; }
  [[nodiscard]] TextureUse& texture(Slot slot) { return textures[size_t(slot)]; }
};

/// Whether the material has any lobe beyond the metallic-roughness BRDF (shared/scene.h, Lobes).
[[nodiscard]] bool has_lobes(const Material& material);

/// Whether its normals are tilted in the frame of the surface's tangent, by a texture or by anisotropy.
[[nodiscard]] bool needs_tangents(const Material& material);

}  // namespace crsh::scene
