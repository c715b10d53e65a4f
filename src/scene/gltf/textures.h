#pragma once
// glTF textures and their images.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/gltf/document.h"
#include "scene/gltf/extension.h"
#include "scene/gltf/fault.h"
#include "scene/gltf/image_reader.h"
#include "scene/scene.h"

namespace crsh::scene {

/// Reads textures when a material first asks for them. Until start_reading() it only takes down which images that will
/// be, and gives no texture: these are then decoded together, on all cores.
class TextureReader {
 public:
  TextureReader(Document& document, Scene& scene, Notes& notes)
      : document_(document), scene_(scene), notes_(notes), images_(document) {}

  void start_reading() { reading_ = true; }

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
  std::nullopt_t want(int index);
  std::optional<uint32_t> read_texture(int index);
  std::optional<uint32_t> image(const std::vector<int>& sources);
  void note_sources(const std::vector<int>& sources, size_t drawn);

  Document& document_;
  Scene& scene_;
  Notes& notes_;
  std::map<int, std::optional<uint32_t>> textures_;
  ImageReader images_;
  bool reading_ = false;
};

}  // namespace crsh::scene
