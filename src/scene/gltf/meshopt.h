#pragma once
// EXT_meshopt_compression and KHR_meshopt_compression: bufferViews whose bytes are compressed.

#include <cstdint>
#include <span>
#include <string>

#include "scene/gltf/uri.h"

namespace crsh::scene {

/// The extension's object in a bufferView. Types are checked, values are not.
struct CompressedView {
  int64_t buffer = 0;
  uint64_t offset = 0, length = 0;  ///< of the compressed bytes in that buffer
  uint64_t stride = 0, count = 0;   ///< of the decompressed elements
  std::string mode, filter;
};

/// How many bytes it has once decompressed. A Fault where it claims more than `length` bytes can hold, or does not say
/// what its mode and filter can do: nothing was allocated by then.
[[nodiscard]] uint64_t checked_size(const CompressedView& view, const std::string& where);

/// The decompressed bytes of a view whose size was checked. A Fault where `data` is broken or of a newer codec than the
/// library here knows.
[[nodiscard]] Bytes decompressed(const CompressedView& view, std::span<const uint8_t> data, const std::string& where);

}  // namespace crsh::scene
