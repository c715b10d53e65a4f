#pragma once
// The points to shade at one bounce: what the raster pass (k = 0) or the hits of the bounce before yield.

#include <cstdint>

#include "gpu/buffer.h"

namespace crsh::shading {

/// Seven buffers of vec4, one element a surface; the paper's position, normal, diffuse and specular, and what
/// refraction and emission need. Shaders bind them in this order.
struct Surfaces {
  gpu::Buffer position;   ///< xyz: world position; w: bits of the drawn triangle's id, `none` where nothing was met
  gpu::Buffer normal;     ///< xyz: shading normal, unit, on the incoming ray's side; w: transmission, 0..1
  gpu::Buffer geometric;  ///< xyz: geometric normal, unit, turned to the incoming ray; w: roughness
  gpu::Buffer incoming;   ///< xyz: unit direction of the ray that came; w: eta = n(this side) / n(other side), 1 where it does not bend
  gpu::Buffer diffuse;    ///< rgb: diffuse albedo (base colour, less metal and transmission); w: bits of the pixel, row-major in the image
  gpu::Buffer specular;   ///< rgb: F0; w: bits of the path: 1, then a bit a bounce (0 reflected, 1 refracted)
  gpu::Buffer emission;   ///< rgb: cd/m2; w: unused
  gpu::Buffer tint;       ///< rgb: what a transmitted ray is multiplied by (base colour); w: unused
  uint32_t count = 0;
};

}  // namespace crsh::shading
