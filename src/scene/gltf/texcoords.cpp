#include "scene/gltf/texcoords.h"

#include <algorithm>
#include <set>

#include "scene/gltf/extension.h"

namespace crsh::scene {

namespace {

template <class Info>
void add(const Info& info, std::set<uint32_t>& used) {
  if (info.index < 0) return;
  const auto transform = Extension::of(info.extensions, "KHR_texture_transform", "");
  const int own = transform && transform->has("texCoord") ? transform->index("texCoord") : info.texCoord;
  used.insert(uint32_t(std::max(own, 0)));
}

/// Every number called texCoord in the value: of an extension's textures, and of their transforms.
void add_all(const tinygltf::Value& value, std::set<uint32_t>& used) {
  if (!value.IsObject()) return;
  for (const std::string& key : value.Keys()) {
    const tinygltf::Value& field = value.Get(key);
    if (key == "texCoord" && field.IsNumber()) used.insert(uint32_t(std::max(field.GetNumberAsInt(), 0)));
    else add_all(field, used);
  }
}

}  // namespace

std::array<uint32_t, uv_sets> texcoords_used(const Document& document) {
  std::set<uint32_t> used;
  for (const tinygltf::Material& material : document.model().materials) {
    add(material.pbrMetallicRoughness.baseColorTexture, used);
    add(material.pbrMetallicRoughness.metallicRoughnessTexture, used);
    add(material.normalTexture, used);
    add(material.occlusionTexture, used);
    add(material.emissiveTexture, used);
    for (const auto& [name, extension] : material.extensions) add_all(extension, used);
  }
  std::array<uint32_t, uv_sets> out{};
  for (uint32_t i = 0; i < uv_sets; ++i) out[i] = i;  // where few are used
  if (!used.empty() && *used.rbegin() >= uv_sets) {
    std::set<uint32_t> all = used;
    for (uint32_t i = 0; all.size() < uv_sets; ++i) all.insert(i);
    std::copy_n(all.begin(), uv_sets, out.begin());
  }
  return out;
}

}  // namespace crsh::scene
