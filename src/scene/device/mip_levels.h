#pragma once
// The smaller levels of a texture, by which it is filtered where it is seen small.

#include <cstdint>
#include <vector>

#include "scene/material.h"

namespace crsh::scene {

/// The size of the level below.
[[nodiscard]] constexpr uint32_t halved(uint32_t size) { return size > 1 ? size / 2 : 1; }
/// How many levels lie below an image of this size, down to one texel.
[[nodiscard]] uint32_t levels_below(uint32_t width, uint32_t height);
/// The image at half its size: each texel is the mean, in linear light, of what it covers. `srgb`: RGB is coded so.
[[nodiscard]] Image next_level(const Image& image, bool srgb);
/// Linear light of 8 bits, 0 to 1.
[[nodiscard]] double linear_of(uint8_t coded, bool srgb);

}  // namespace crsh::scene
