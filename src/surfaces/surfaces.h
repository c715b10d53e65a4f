#pragma once
// The points to shade at one bounce: what the raster pass (k = 0) or the hits of the bounce before yield.

#include <array>
#include <cstdint>
#include <vector>

#include "crsh/options.h"
#include "gpu/buffer.h"
#include "gpu/recorder.h"
#include "raster/camera.h"
#include "raster/raster.h"
#include "scene/device/upload.h"
#include "shared/limits.h"

namespace crsh::surfaces {

/// Six buffers of vec4, one element a surface; the paper's position, normal, diffuse and specular, and what reflection
/// and refraction need. Where nothing was met all is 0 but the triangle, the ray that came, pixel and path. Shaders
/// bind them in this order.
struct Surfaces {
  gpu::Buffer position;   ///< xyz: world position; w: bits of the drawn triangle's id, `none` where nothing was met
  gpu::Buffer normal;     ///< xyz: shading normal, unit, on the incoming ray's side; w: transmission, 0..1
  gpu::Buffer geometric;  ///< xyz: geometric normal, unit, turned to the incoming ray; w: roughness
  /// xyz: unit direction of the ray that came; w: eta = n(this side) / n(other side), 1: no bend
  gpu::Buffer incoming;
  gpu::Buffer diffuse;   ///< rgb: base colour less metal, transmission included; w: bits of the pixel, row-major
  gpu::Buffer specular;  ///< rgb: F0; w: bits of the path: 1, then a bit a bounce (0 reflected, 1 refracted)
  uint32_t count = 0;
};

/// The closest-hit rays of one batch, whose hits are surfaces of the next generation.
struct Children {
  gpu::Buffer ends;            ///< the batch's: uint a slot, the inclusive scan of its head flags
  uint32_t first_surface = 0;  ///< of the parents: the batch's slot 0 of each segment
  uint32_t surfaces = 0;       ///< slots a segment
  std::array<uint32_t, kind_count> first_slot = {shared::none, shared::none, shared::none};  ///< of the kind's segment
  uint32_t first_ray = 0;               ///< of the batch's closest-hit rays; in creation order they are, from there on,
  uint32_t first_child = 0;             ///< the surfaces of the next generation from this one on
  const gpu::Buffer* totals = nullptr;  ///< of the next generation, once that is gathered
};

/// What stays of a generation of surfaces until the gathering comes back to it.
struct Generation {
  gpu::Buffer emission;           ///< vec4: cd/m2; w: F0's part that is not base colour; -1 where nothing was met
  gpu::Buffer direct;             ///< vec4: light that shadow rays let through, cd/m2
  gpu::Buffer reflection_weight;  ///< vec4; written where the kind is cast
  gpu::Buffer refraction_weight;
  std::vector<Children> children;  ///< in order of surfaces
  uint32_t count = 0;
};

/// Room for `count` surfaces; where it has to grow, what is recorded is submitted and old contents are lost.
void reserve(gpu::Recorder& recorder, Surfaces& surfaces, Generation& generation, uint32_t count);

struct FromRasterIn {
  const raster::GBuffer& gbuffer;
  const scene::GpuScene& scene;
  const raster::CameraView& view;
  raster::ImageSize size;
  RayOrder order = RayOrder::scanline;
  uint32_t first = 0, count = 0;  ///< pixels of that order: all, or a run of them
};

/// Generation 0: pixels in the order in which they make rays.
void from_raster(gpu::Recorder& recorder, const FromRasterIn& in, Surfaces& surfaces, Generation& generation);

struct FromHitsIn {
  const scene::GpuScene& scene;
  const gpu::Buffer& rays;   ///< shared::Ray, of the batch, in creation order
  const gpu::Buffer& slots;  ///< uint a ray
  const gpu::Buffer& hits;   ///< shared::Hit a ray, in creation order
  const Children& children;  ///< `first_ray` on: the rays; their surfaces go to `first_child` on
  uint32_t count = 0;        ///< closest-hit rays
  const Surfaces& parents;
};

/// Generation k + 1: where the reflection and refraction rays of one batch hit. `surfaces` must have room (reserve) for
/// in.children.first_child + in.count; both counts become that.
void from_hits(gpu::Recorder& recorder, const FromHitsIn& in, Surfaces& surfaces, Generation& generation);

}  // namespace crsh::surfaces
