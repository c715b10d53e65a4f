#pragma once
// The place of each sample in its pixel.

#include <cstdint>
#include <glm/glm.hpp>

namespace crsh::raster {

/// Where sample `index` is, relative to the pixel's centre, -0.5..0.5 an axis. The first one is at the centre; the
/// others are the R2 sequence (Roberts 2018), shifted by the seed.
[[nodiscard]] glm::vec2 jitter(uint32_t index, uint32_t seed);

}  // namespace crsh::raster
