#pragma once
// glTF textures and their images.

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "scene/gltf/document.h"
#include "scene/gltf/extension.h"
#include "scene/gltf/fault.h"
#include "scene/scene.h"

namespace crsh::scene {

/// Reads images and textures when a material first asks for them.
class TextureReader {
 public:
  TextureReader(Document& document, Scene& scene, Notes& notes) : document_(document), scene_(scene), notes_(notes) {}

  /// The texture that a material names, if it can be drawn.
  template <class Info>
  [[nodiscard]] TextureUse use(const Info& info, const std::string& where) {
    if (info.index < 0) return {};
    return use(info.index, info.texCoord, Extension::of(info.extensions, "KHR_texture_transform", where));
  }
  /// The same for a field of a material's extension.
  [[nodiscard]] TextureUse use(const Extension& extension, const std::string& key);

 private:
  TextureUse use(int index, int texcoord, const std::optional<Extension>& transform);
  uint32_t slot_of(uint32_t set);
  std::optional<uint32_t> texture(int index);
  std::optional<uint32_t> read_texture(int index);
  std::optional<uint32_t> image(int index);
  std::optional<uint32_t> read_image(int index);
  Image decoded(const ImageSource& source);

  Document& document_;
  Scene& scene_;
  Notes& notes_;
  std::map<int, std::optional<uint32_t>> textures_, images_;
  uint64_t texels_ = 0;
};

}  // namespace crsh::scene
