#pragma once
// PNG and JPEG decoding.

#include <cstdint>
#include <span>

#include "scene/scene.h"

namespace crsh::scene {

/// Decodes a PNG or JPEG to RGBA8. Throws a Fault where it is neither, is broken, or has a side longer than 16,384
/// texels.
[[nodiscard]] Image decode_image(std::span<const uint8_t> bytes);

}  // namespace crsh::scene
