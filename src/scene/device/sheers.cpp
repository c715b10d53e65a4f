#include "scene/device/sheers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "shared/limits.h"

namespace crsh::scene {
namespace {

/// Of a material with alpha.
struct SheerMaterial {
  float factor = 1;
  float least_texel = 1;                    ///< of the base colour's texture
  float cutoff = -1;                        ///< negative: BLEND
  uint32_t through = 0;                     ///< as shared::Sheer has it
  const shared::TextureUse* use = nullptr;  ///< null: no texture
};

float least_alpha(const Image& image) {
  uint8_t least = 255;
  for (size_t i = 3; i < image.rgba.size(); i += 4) least = std::min(least, image.rgba[i]);
  return float(least) / 255;
}

/// What a shadow ray's tint is (tint_of), in 10 bits a channel.
uint32_t packed_through(const glm::uvec4& tint) {
  uint32_t word = 0;
  for (int c = 0; c < 3; ++c) {
    const double through = tint[c] == 0xFFFFFFFFu ? 0 : std::exp2(double(tint[c]) / -65536);
    word |= uint32_t(std::lround(through * 1023)) << 10 * c;
  }
  return word;
}

/// Nothing for a material that has no alpha. A cutoff below 0 cuts nothing away, and 0 neither.
std::optional<SheerMaterial> sheer_material(const Scene& scene, const DeviceMaterials& materials, size_t index) {
  const Material& from = scene.materials[index];
  const shared::Material& to = materials.materials[index];
  const bool masks = from.alpha_mode == AlphaMode::mask;
  if (from.alpha_mode == AlphaMode::opaque || (masks && !(from.alpha_cutoff > 0))) return {};
  SheerMaterial out;
  out.factor = from.base_colour.a;
  if (masks) out.cutoff = from.alpha_cutoff;
  if (!masks) out.through = packed_through(to.tint);
  if ((to.slots & 1u << shared::slot_base_colour) == 0) return out;
  out.use = &materials.uses[to.first_use];  // the first slot
  out.least_texel = least_alpha(scene.images[scene.textures[*from.texture(Slot::base_colour).texture].image]);
  return out;
}

/// As scene/surface.glsl transforms it.
glm::vec2 transformed(const shared::TextureUse& use, glm::vec2 uv) {
  return glm::vec2(use.matrix.x, use.matrix.z) * uv.x + glm::vec2(use.matrix.y, use.matrix.w) * uv.y + use.offset;
}

bool falls_short(const SheerMaterial& material, glm::vec3 alpha) {
  const float least = std::min({alpha.x, alpha.y, alpha.z}) * material.least_texel;
  return least < (material.cutoff < 0 ? 1.0f : material.cutoff);
}

std::optional<shared::Sheer> record_of(const Mesh& mesh, const SheerMaterial& material, glm::uvec3 corners) {
  shared::Sheer out{};
  for (int i = 0; i < 3; ++i) {
    out.alpha[i] = unpacked_colour(mesh.colours[corners[i]]).a * material.factor;
    if (!material.use) continue;
    const std::vector<glm::vec2>& uv = mesh.uv[material.use->uv_set];
    out.uv[i] = transformed(*material.use, uv.empty() ? glm::vec2(0) : uv[corners[i]]);
  }
  out.cutoff = material.cutoff;
  out.texture = material.use ? material.use->texture : shared::none;
  out.through = material.through;
  return falls_short(material, out.alpha) ? std::optional(out) : std::nullopt;
}

uint32_t pages_of(const std::vector<shared::Sheer>& records, const DeviceMaterials& materials) {
  uint32_t pages = records.empty() ? 0 : 1;
  for (const shared::Sheer& record : records)
    if (record.texture != shared::none) pages = std::max(pages, (materials.textures[record.texture].flags & 3u) + 1);
  return pages;
}

}  // namespace

Sheers sheers_of(const Scene& scene, const Storage& storage, const DeviceMaterials& materials) {
  std::vector<std::optional<SheerMaterial>> sheer;
  for (size_t i = 0; i < scene.materials.size(); ++i) sheer.push_back(sheer_material(scene, materials, i));
  Sheers out;
  for (const StoredMesh& stored : storage.meshes) {
    const Mesh& mesh = scene.meshes[stored.mesh];
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
      const std::optional<SheerMaterial>& material = sheer[mesh.materials[t]];
      const auto record = material ? record_of(mesh, *material, mesh.triangles[t]) : std::nullopt;
      out.of_stored.push_back(record ? uint32_t(out.records.size()) : shared::none);
      if (record) out.records.push_back(*record);
    }
  }
  out.pages = pages_of(out.records, materials);
  return out;
}

}  // namespace crsh::scene
