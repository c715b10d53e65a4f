#include "scene/device/device_materials.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "shared/limits.h"

namespace crsh::scene {
namespace {

double linear_of(uint8_t coded, bool srgb) {
  const double c = coded / 255.0;
  if (!srgb) return c;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

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

double normal_reflectance(double ior) {
  const double root = (ior - 1) / (ior + 1);
  return root * root;
}

uint32_t fixed_minus_log2(double through) {
  if (!(through > 0)) return 0xFFFFFFFFu;
  return uint32_t(std::min(std::round(-std::log2(std::min(through, 1.0)) * 65536), double(0xFFFFFFFEu)));
}

bool transmits(const Material& material) { return material.transmission > 0 && material.metallic < 1; }

/// Whether it is a solid that bends rays. Rays must hit its far side from inside, even where the material is not
/// doubleSided.
bool is_solid(const Material& material) { return material.transmission > 0 && material.thickness > 0; }

/// All flags of a texture's word but the page.
uint32_t flags_of(const Texture& texture, bool srgb) {
  return uint32_t(texture.wrap_s) << shared::texture_wrap_s_shift |
         uint32_t(texture.wrap_t) << shared::texture_wrap_t_shift | (texture.nearest ? shared::texture_nearest : 0) |
         (srgb ? shared::texture_srgb : 0);
}

/// Numbers textures in the order in which materials use them.
class TextureTable {
 public:
  explicit TextureTable(const Scene& scene) : scene_(scene) {}

  /// The word of a shared::Material for this use.
  uint32_t word(const TextureUse& use, bool srgb) {
    if (!use.texture || scene_.images[scene_.textures[*use.texture].image].rgba.empty()) return shared::none;
    const auto [entry, is_new] = numbers_.try_emplace({*use.texture, srgb}, uint32_t(numbers_.size()));
    if (is_new) keys_.push_back(entry->first);
    return entry->second << 1 | (use.texcoord & 1);
  }

  [[nodiscard]] std::vector<bool> used_images() const {
    std::vector<bool> used(scene_.images.size(), false);
    for (const auto& [texture, srgb] : keys_) used[scene_.textures[texture].image] = true;
    return used;
  }

  [[nodiscard]] std::vector<shared::Texture> textures(const TexelPages& texels) const {
    std::vector<shared::Texture> all;
    for (const auto& [index, srgb] : keys_) {
      const Texture& texture = scene_.textures[index];
      const Placement at = *texels.placements[texture.image];
      all.push_back({at.first, at.width, at.height, at.page | flags_of(texture, srgb)});
    }
    return all;
  }

 private:
  using Key = std::pair<uint32_t, bool>;
  const Scene& scene_;
  std::map<Key, uint32_t> numbers_;
  std::vector<Key> keys_;
};

shared::Material device_material(const Scene& scene, const Material& material, TextureTable& textures) {
  shared::Material out{};
  out.base_colour = material.base_colour;
  out.emissive_metallic = glm::vec4(material.emissive, material.metallic);
  out.body = {material.roughness, material.transmission, material.ior, material.thickness};
  out.textures = {textures.word(material.base_colour_texture, true),
                  textures.word(material.metallic_roughness_texture, false),
                  textures.word(material.emissive_texture, true), textures.word(material.transmission_texture, false)};
  out.tint = tint_of(scene, material);
  return out;
}

}  // namespace

glm::uvec4 tint_of(const Scene& scene, const Material& material) {
  if (!transmits(material)) return glm::uvec4(0xFFFFFFFFu, 0xFFFFFFFFu, 0xFFFFFFFFu, 0);
  const double metallic = material.metallic * mean(scene, material.metallic_roughness_texture, false).b;
  const double transmission = material.transmission * mean(scene, material.transmission_texture, false).r;
  const glm::dvec3 through = glm::dvec3(material.base_colour) * mean(scene, material.base_colour_texture, true) *
                             (transmission * (1 - metallic) * (1 - normal_reflectance(material.ior)));
  return {fixed_minus_log2(through.r), fixed_minus_log2(through.g), fixed_minus_log2(through.b), 0};
}

uint32_t flagged_material(const Scene& scene, uint32_t index) {
  const Material& material = scene.materials[index];
  uint32_t word = index;
  if (!material.double_sided && !is_solid(material)) word |= shared::triangle_cull_back;
  if (transmits(material)) word |= shared::triangle_transmissive;
  return word;
}

DeviceMaterials device_materials(const Scene& scene, uint64_t page_texels) {
  DeviceMaterials out;
  TextureTable textures(scene);
  for (const Material& material : scene.materials) out.materials.push_back(device_material(scene, material, textures));
  out.texels = pack_texels(scene.images, textures.used_images(), page_texels);
  out.textures = textures.textures(out.texels);
  return out;
}

}  // namespace crsh::scene
