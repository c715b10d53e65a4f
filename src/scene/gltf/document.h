#pragma once
// A glTF file's JSON and binary data.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <unordered_map>

#include "scene/gltf/fields.h"
#include "scene/gltf/uri.h"

namespace crsh::scene {

/// One file, .gltf or .glb (told apart by content). Buffers are read when first asked for, and every range is checked.
class Document {
 public:
  /// `most_work`: how many elements spend() allows.
  explicit Document(const std::filesystem::path& path, uint64_t most_work = uint64_t{1} << 30u);
  ~Document();
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;

  [[nodiscard]] Fields root() const;
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  /// The bytes of a bufferView.
  [[nodiscard]] std::span<const uint8_t> view(uint64_t index);
  /// Counts work that a small file could ask for without end (one array read by thousands of meshes); a Fault when it
  /// is too much.
  void spend(uint64_t elements);

 private:
  std::span<const uint8_t> buffer(uint64_t index);
  Bytes read_buffer(const Fields& fields, uint64_t index, uint64_t length) const;

  std::filesystem::path folder_;
  std::unique_ptr<nlohmann::json> json_;
  std::optional<Bytes> binary_;  // the GLB's BIN chunk
  std::unordered_map<uint64_t, Bytes> buffers_;
  uint64_t work_left_;
};

}  // namespace crsh::scene
