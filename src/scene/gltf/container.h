#pragma once
// The two wrappings of a glTF file.

#include <cstdint>
#include <optional>
#include <span>

namespace crsh::scene {

/// What a file holds, as parts of its bytes.
struct Container {
  std::span<const uint8_t> text;                   ///< JSON
  std::optional<std::span<const uint8_t>> binary;  ///< a GLB's BIN chunk
};

/// Tells .glb and .gltf apart by content. A Fault where the file is empty or its chunks reach past its end.
[[nodiscard]] Container open_container(std::span<const uint8_t> bytes);

}  // namespace crsh::scene
