#include "scene/device/device_materials.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "scene/device/mip_levels.h"
#include "shared/limits.h"

namespace crsh::scene {
namespace {

/// The mean of a texture in linear light; white where there is no texture.
glm::dvec3 mean(const Scene& scene, const TextureUse& use, bool srgb) {
  if (!use.texture) return glm::dvec3(1);
  const Image& image = scene.images[scene.textures[*use.texture].image];
  const size_t texels = size_t(image.width) * image.height;
  if (texels == 0) return glm::dvec3(1);
  std::array<double, 256> decoded{};
  for (size_t i = 0; i < 256; ++i) decoded[i] = linear_of(uint8_t(i), srgb);
  glm::dvec3 sum(0);
  for (size_t i = 0; i < texels; ++i)
    sum += glm::dvec3(decoded[image.rgba[4 * i]], decoded[image.rgba[4 * i + 1]], decoded[image.rgba[4 * i + 2]]);
  return sum / double(texels);
}

bool transmits(const Material& material) {
  return material.transmission > 0 && material.metallic < 1 && !material.unlit;
}

/// At some time of an animation.
bool may_transmit(const Material& material) {
  return transmits(material) || (material.may_transmit && !material.unlit);
}

/// Whether it is a solid that bends rays. Rays must hit its far side from inside, even where the material is not
/// doubleSided.
bool is_solid(const Material& material) {
  return (material.transmission > 0 || material.may_transmit) && material.thickness > 0 && !material.unlit;
}

double normal_reflectance(double ior) {
  const double root = (ior - 1) / (ior + 1);
  return root * root;
}

/// Beer's law: what is left after one metre is exp of minus this (KHR_materials_volume).
glm::vec3 absorption_of(const Attenuation& attenuation) {
  return -glm::log(glm::max(attenuation.colour, glm::vec3(1e-6f))) / attenuation.distance;
}

/// At the normal, of the channel that is reflected most (KHR_materials_specular).
double dielectric_reflectance(const Material& material) {
  const double f0 = normal_reflectance(material.ior);
  if (material.specular == Specular{}) return f0;
  const glm::dvec3 coloured = glm::min(f0 * glm::dvec3(material.specular.colour), 1.0);
  return material.specular.factor * std::max({coloured.r, coloured.g, coloured.b});
}

/// What one of the two crossings of a solid leaves, as shadow rays know no distances inside: the file's thickness is
/// taken for that, as rasterising viewers do.
glm::dvec3 half_absorbed(const Material& material) {
  if (!is_solid(material) || material.attenuation == Attenuation{}) return glm::dvec3(1);
  return glm::exp(-0.5 * double(material.thickness) * glm::dvec3(absorption_of(material.attenuation)));
}

uint32_t fixed_minus_log2(double through) {
  if (!(through > 0)) return 0xFFFFFFFFu;
  return uint32_t(std::min(std::round(-std::log2(std::min(through, 1.0)) * 65536), double(0xFFFFFFFEu)));
}

/// All flags of a texture's word but the page and the number of levels.
uint32_t flags_of(const Texture& texture, bool srgb) {
  return uint32_t(texture.wrap_s) << shared::texture_wrap_s_shift |
         uint32_t(texture.wrap_t) << shared::texture_wrap_t_shift | (texture.nearest ? shared::texture_nearest : 0) |
         (texture.nearest_in_level ? shared::texture_nearest_in_level : 0) |
         (texture.mips == Mips::nearest ? shared::texture_nearest_level : 0) | (srgb ? shared::texture_srgb : 0);
}

/// KHR_texture_transform: scaled, turned, moved. It is turned counter-clockwise as one sees it, v going down: so the
/// extension's words have it, and every viewer; the matrix written there in GLSL turns the other way.
shared::TextureUse device_use(uint32_t texture, const TextureUse& use) {
  const TextureTransform& by = use.transform;
  const float c = std::cos(by.rotation), s = std::sin(by.rotation);
  return {texture, use.texcoord, {c * by.scale.x, s * by.scale.y, -s * by.scale.x, c * by.scale.y}, by.offset};
}

/// Numbers textures, each with its levels, in the order in which materials use them.
class TextureTable {
 public:
  explicit TextureTable(const Scene& scene) : scene_(scene) {}

  /// Sets which slots the material has and where their uses are.
  void add(const Material& from, shared::Material& out) {
    out.first_use = uint32_t(uses_.size());
    for (uint32_t slot = 0; slot < slot_count; ++slot) {
      const TextureUse& use = from.textures[slot];
      if (!use.texture || scene_.images[scene_.textures[*use.texture].image].rgba.empty()) continue;
      out.slots |= 1u << slot;
      uses_.push_back({number_of(*use.texture, is_srgb(Slot(slot))), &use});
    }
  }

  [[nodiscard]] std::vector<Picture> pictures() const { return pictures_; }

  /// Once the pictures are placed.
  void write(const TexelPages& texels, DeviceMaterials& out) const {
    std::vector<uint32_t> first;
    for (const Key& key : keys_) {
      first.push_back(uint32_t(out.textures.size()));
      const std::vector<Placement>& levels = texels.placements[key.picture];
      const uint32_t flags = flags_of(scene_.textures[key.texture], key.srgb);
      for (size_t level = 0; level < levels.size(); ++level) {
        const Placement& at = levels[level];
        const auto below = uint32_t(levels.size() - 1 - level);
        out.textures.push_back(
            {at.first, at.width, at.height, at.page | flags | below << shared::texture_levels_shift});
      }
    }
    for (const Use& use : uses_) out.uses.push_back(device_use(first[use.number], *use.use));
  }

 private:
  struct Key {
    uint32_t texture;
    bool srgb;
    size_t picture;
  };
  struct Use {
    uint32_t number;  // of the key
    const TextureUse* use;
  };

  uint32_t number_of(uint32_t texture, bool srgb) {
    const auto [entry, is_new] = numbers_.try_emplace({texture, srgb}, uint32_t(keys_.size()));
    if (is_new) keys_.push_back({texture, srgb, picture_of(scene_.textures[texture], srgb)});
    return entry->second;
  }

  /// Textures that differ in their wrapping alone share texels.
  size_t picture_of(const Texture& texture, bool srgb) {
    const bool mips = texture.mips != Mips::none;
    const Picture picture{texture.image, mips && srgb, mips};
    const auto found = std::find(pictures_.begin(), pictures_.end(), picture);
    if (found != pictures_.end()) return size_t(found - pictures_.begin());
    pictures_.push_back(picture);
    return pictures_.size() - 1;
  }

  const Scene& scene_;
  std::map<std::pair<uint32_t, bool>, uint32_t> numbers_;
  std::vector<Key> keys_;
  std::vector<Picture> pictures_;
  std::vector<Use> uses_;
};

uint32_t flags_of(const Material& material) {
  return (material.unlit ? shared::material_unlit : 0) |
         (material.alpha_mode == AlphaMode::mask ? shared::material_mask : 0) |
         (material.alpha_mode == AlphaMode::blend ? shared::material_blend : 0) |
         (material.specular_glossiness ? shared::material_specular_glossiness : 0);
}

shared::Material device_material(const Scene& scene, const Material& material) {
  shared::Material out{};
  out.lobes = shared::none;
  out.flags = flags_of(material);
  set_factors(scene, material, out);
  return out;
}

shared::Lobes device_lobes(const Material& m) {
  const SpecularGlossiness glossy = m.specular_glossiness.value_or(SpecularGlossiness{});
  return {glm::vec4(m.specular.colour, m.specular.factor),
          {m.clearcoat.factor, m.clearcoat.roughness, m.clearcoat.normal_scale, m.dispersion},
          glm::vec4(m.sheen.colour, m.sheen.roughness),
          {m.iridescence.factor, m.iridescence.ior, m.iridescence.min_thickness, m.iridescence.max_thickness},
          {m.anisotropy.strength, std::cos(m.anisotropy.rotation), std::sin(m.anisotropy.rotation), 0},
          glm::vec4(absorption_of(m.attenuation), 0),
          glm::vec4(m.diffuse_transmission.colour, m.diffuse_transmission.factor),
          glm::vec4(glossy.specular, glossy.glossiness)};
}

}  // namespace

void set_factors(const Scene& scene, const Material& material, shared::Material& out) {
  out.base_colour = material.base_colour;
  out.emissive_metallic = glm::vec4(material.emissive, material.metallic);
  out.body = {material.roughness, material.transmission, material.ior, material.thickness};
  out.detail = {material.normal_scale, material.occlusion_strength, material.alpha_cutoff, 0};
  out.tint = tint_of(scene, material);
  if (!material.unlit) return;
  out.emissive_metallic = glm::vec4(0);  // base colour is all that counts
  out.body.y = 0;
}

glm::uvec4 tint_of(const Scene& scene, const Material& material) {
  if (!transmits(material)) return glm::uvec4(0xFFFFFFFFu, 0xFFFFFFFFu, 0xFFFFFFFFu, 0);
  const double metallic = material.metallic * mean(scene, material.texture(Slot::metallic_roughness), false).b;
  const double transmission = material.transmission * mean(scene, material.texture(Slot::transmission), false).r;
  const glm::dvec3 through = glm::dvec3(material.base_colour) * mean(scene, material.texture(Slot::base_colour), true) *
                             (transmission * (1 - metallic) * (1 - dielectric_reflectance(material))) *
                             half_absorbed(material);
  return {fixed_minus_log2(through.r), fixed_minus_log2(through.g), fixed_minus_log2(through.b), 0};
}

uint32_t flagged_material(const Scene& scene, uint32_t index) {
  const Material& material = scene.materials[index];
  uint32_t word = index;
  if (!material.double_sided && !is_solid(material)) word |= shared::triangle_cull_back;
  if (may_transmit(material)) word |= shared::triangle_transmissive;
  return word;
}

DeviceMaterials device_materials(const Scene& scene, uint64_t page_texels) {
  DeviceMaterials out;
  TextureTable textures(scene);
  for (const Material& material : scene.materials) {
    out.materials.push_back(device_material(scene, material));
    textures.add(material, out.materials.back());
    if (!has_lobes(material)) continue;
    out.materials.back().lobes = uint32_t(out.lobes.size());
    out.lobes.push_back(device_lobes(material));
  }
  out.texels = pack_texels(scene.images, textures.pictures(), page_texels);
  textures.write(out.texels, out);
  return out;
}

}  // namespace crsh::scene
