#pragma once
// Where in its pixel each sample lies.

#include <cstdint>
#include <glm/glm.hpp>

namespace crsh::raster {

/// Sample `index`'s distance from the pixel's centre, -0.5..0.5 an axis: the first one is the centre, the others are
/// the R2 sequence (Roberts 2018), turned by the seed.
[[nodiscard]] glm::vec2 jitter(uint32_t index, uint32_t seed);

}  // namespace crsh::raster
