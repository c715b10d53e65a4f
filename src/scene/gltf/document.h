#pragma once
// A glTF file: what tinygltf reads in its JSON, and its binary data.

#include <tiny_gltf.h>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "scene/gltf/element_type.h"
#include "scene/gltf/known_extensions.h"
#include "scene/gltf/prepare.h"
#include "scene/gltf/uri.h"

namespace crsh::scene {

/// An accessor's elements, tightly packed, that did not come from its bufferView.
struct Decoded {
  uint64_t count = 0;
  ElementType type;
  Bytes bytes;
};

/// One file, .gltf or .glb (told apart by content). tinygltf sees neither buffers nor images: they are read here, when
/// first asked for, and every range is checked.
class Document {
 public:
  /// `max_work`: how many elements spend() allows; `lenient`: required extensions may be missing here.
  explicit Document(const std::filesystem::path& path, Reach reach = Reach::folder,
                    uint64_t max_work = uint64_t{1} << 30u, bool lenient = false);

  /// Its types are checked, its references are not: see at() in checked.h.
  [[nodiscard]] const tinygltf::Model& model() const { return model_; }
  [[nodiscard]] const ExtensionNames& extensions() const { return extensions_; }
  /// The bytes of a bufferView, decompressed where they are compressed.
  [[nodiscard]] std::span<const uint8_t> view(int64_t index);
  [[nodiscard]] const ImageSource& image(int64_t index) const;
  /// A Fault where what stands at `where` was found broken before.
  void check(const std::string& where) const;
  /// Elements to read in place of the accessor's own.
  void keep(int64_t accessor, Decoded elements) { decoded_[accessor] = std::move(elements); }
  /// Those that were kept; null: none.
  [[nodiscard]] const Decoded* decoded(int64_t accessor) const;
  /// The bytes behind a URI of the file.
  [[nodiscard]] Bytes read(const std::string& uri) const;
  /// Counts work that a small file could ask for without end (one array read by thousands of meshes); a Fault when it
  /// is too much.
  void spend(uint64_t elements);

 private:
  std::span<const uint8_t> buffer(int64_t index);
  std::span<const uint8_t> part(int64_t of_buffer, uint64_t offset, uint64_t length, const std::string& where);
  std::span<const uint8_t> decompress(int64_t index, const CompressedView& view);
  [[nodiscard]] bool has_own_data(int64_t buffer) const;
  Bytes read_buffer(const BufferSource& source, int64_t index) const;

  std::filesystem::path folder_;
  Reach reach_;
  ExtensionNames extensions_;
  std::optional<Bytes> binary_;  // the GLB's BIN chunk
  std::vector<BufferSource> sources_;
  std::vector<ImageSource> images_;
  std::map<int64_t, CompressedView> compressed_;
  BrokenParts broken_;
  tinygltf::Model model_;
  std::unordered_map<int64_t, Bytes> buffers_, decompressed_;  // spans go into them: nothing is ever taken out
  std::unordered_map<int64_t, Decoded> decoded_;
  uint64_t work_left_;
};

}  // namespace crsh::scene
