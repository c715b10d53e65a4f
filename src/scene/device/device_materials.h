#pragma once
// Materials and textures as shaders see them (shared/scene.h).

#include <cstdint>
#include <vector>

#include "scene/device/texel_pages.h"
#include "scene/scene.h"
#include "shared/scene.h"

namespace crsh::scene {

struct DeviceMaterials {
  std::vector<shared::Material> materials;  ///< as in Scene::materials
  std::vector<shared::TextureUse> uses;     ///< of their textures, in the order of the slots
  std::vector<shared::Lobes> lobes;         ///< of the materials that have any
  std::vector<shared::Texture> textures;    ///< for each glTF texture and decoding (sRGB or linear) its levels
  TexelPages texels;
};

/// All materials, with the textures that they use; images that none uses are left out.
[[nodiscard]] DeviceMaterials device_materials(const Scene& scene, uint64_t page_texels);

/// Gives the device's material all that animations may change: everything but its textures.
void set_factors(const Scene& scene, const Material& material, shared::Material& out);

/// The material's index with the flags of shared/scene.h, as it is stored in the w of a triangle's first corner.
[[nodiscard]] uint32_t flagged_material(const Scene& scene, uint32_t material);

/// -log2 of what one crossing of the material's triangles lets through to a shadow ray, in 16.16 fixed point a
/// channel: transmission, less metal and what Fresnel reflects at the normal, times base colour; textures by their
/// mean. 0xFFFFFFFF where nothing gets through, and only there.
[[nodiscard]] glm::uvec4 tint_of(const Scene& scene, const Material& material);

}  // namespace crsh::scene
