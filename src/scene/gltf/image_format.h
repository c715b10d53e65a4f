#pragma once
// What each decoder of pictures has to offer. Only image.cpp calls them.

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "scene/gltf/image.h"

namespace crsh::scene {

/// A picture's longest side, in texels.
constexpr uint32_t longest_image_side = 16384;
/// 8192 x 8192: 256 MiB.
constexpr uint64_t most_image_texels = uint64_t{1} << 26u;

/// One format. Its functions throw a Fault where the file is broken, and check nothing that image.cpp does.
struct ImageFormat {
  /// Whether the content begins as the format does.
  bool (*is)(std::span<const uint8_t> bytes);
  /// From the head.
  ImageSize (*size)(std::span<const uint8_t> bytes);
  /// Fills `rgba`, which holds `size` texels. Returns the remark.
  std::string (*decode)(std::span<const uint8_t> bytes, ImageSize size, std::span<uint8_t> rgba);
  /// The best that its compression can do, 0 where that has no bound.
  uint64_t max_texels_a_byte;
};

extern const ImageFormat png_format, jpeg_format, webp_format, avif_format;

[[nodiscard]] inline bool begins_with(std::span<const uint8_t> bytes, std::span<const uint8_t> start) {
  if (bytes.size() < start.size()) return false;
  for (size_t i = 0; i < start.size(); ++i)
    if (bytes[i] != start[i]) return false;
  return true;
}

}  // namespace crsh::scene
