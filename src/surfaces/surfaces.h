#pragma once
// Surfaces, the points to shade: generation 0 comes from the raster pass, later ones from the hits of rays.

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

/// Six buffers of vec4 and one of vec2, one element a surface; the paper's position, normal, diffuse and specular, and
/// what reflection and refraction need. Where nothing was met all is 0 but the triangle, the ray that came, pixel and
/// path. Shaders bind them in this order.
struct Surfaces {
  gpu::Buffer position;   ///< xyz: world position; w: bits of the drawn triangle's id, `none` where nothing was met
  gpu::Buffer normal;     ///< xyz: shading normal, unit, on the incoming ray's side; w: transmission, 0..1
  gpu::Buffer geometric;  ///< xyz: geometric normal, unit, turned to the incoming ray; w: roughness
  /// xyz: unit direction of the ray that came; w: eta = n(this side) / n(other side), 1: no bend
  gpu::Buffer incoming;
  gpu::Buffer diffuse;   ///< rgb: base colour less metal, transmission included; w: bits of the pixel, row-major
  gpu::Buffer specular;  ///< rgb: F0; w: bits of the path: 1, then shared::path_bits a bounce: RayKind::turn
  /// vec2: how wide the pixel's cone is there, across the ray that came, metres; how much of the surface is there
  /// (alphaMode BLEND), 0..1
  gpu::Buffer footprint;
  gpu::Buffer lobes;  ///< vec4, shared::surface_lobe_words a surface, where the scene has any lobes; else one
  uint32_t count = 0;
};

/// The rays of one closest-hit kind in a batch, in creation order: their hits are surfaces of the next generation.
struct ChildRun {
  uint32_t first_slot = shared::none;  ///< of the kind's segment; none: the batch has no such rays
  uint32_t first_ray = 0, count = 0;   ///< of the batch
  uint32_t first_child = 0;            ///< surface of the next generation that the first ray's hit is
};

/// The closest-hit rays of one batch.
struct Children {
  gpu::Buffer ends;            ///< the batch's: uint a slot, the inclusive scan of its head flags
  uint32_t first_surface = 0;  ///< of the parents: the batch's slot 0 of each segment
  uint32_t surfaces = 0;       ///< slots a segment
  PerKind<ChildRun> of_kind;
  uint32_t end = 0;                     ///< surfaces of the next generation, with these
  const gpu::Buffer* totals = nullptr;  ///< of the next generation, once that is gathered
};

/// What is kept of a generation of surfaces until its light is gathered.
struct Generation {
  gpu::Buffer emission;            ///< vec4: cd/m2; w: F0's part that is not base colour; -1 where nothing was met
  gpu::Buffer direct;              ///< vec4: light that shadow rays let through, cd/m2
  PerKind<gpu::Buffer> weights;    ///< vec4: of what the kind's rays bring; of closest-hit kinds, where they are cast;
                                   ///< w: of it, what passes by a surface that is not wholly there
  std::vector<Children> children;  ///< in order of surfaces
  uint32_t count = 0;
};

/// Makes room for `count` surfaces. Where a buffer has to grow, its old contents are lost, and what is recorded is
/// submitted first. `lobes`: whether the scene has any.
void reserve(gpu::Recorder& recorder, Surfaces& surfaces, Generation& generation, uint32_t count, bool lobes);

struct FromRasterIn {
  const raster::GBuffer& gbuffer;
  const scene::GpuScene& scene;
  const raster::CameraView& view;
  raster::ImageSize size;
  RayOrder order = RayOrder::scanline;
  uint32_t first = 0, count = 0;  ///< pixels of that order: all, or a run of them
  bool sheets = false;            ///< what lies behind surfaces that are half there shows; else these are drawn whole
};

/// Makes generation 0 of pixels, in the order in which these make rays.
void from_raster(gpu::Recorder& recorder, const FromRasterIn& in, Surfaces& surfaces, Generation& generation);

struct FromHitsIn {
  const scene::GpuScene& scene;
  const gpu::Buffer& rays;   ///< shared::Ray, of the batch, in creation order
  const gpu::Buffer& slots;  ///< uint a ray
  const gpu::Buffer& hits;   ///< shared::Hit a ray, in creation order
  const Children& children;
  const Surfaces& parents;
  PerKind<gpu::Buffer>& parent_weights;  ///< of the rays: solids take their part (Beer's law)
  float cone_spread = 0;                 ///< raster::PixelCone's
  bool sheets = false;                   ///< as FromRasterIn has it
};

/// Generation k + 1: where the closest-hit rays of one batch hit. `surfaces` must have room (reserve) for
/// in.children.end; both counts become that.
void from_hits(gpu::Recorder& recorder, const FromHitsIn& in, Surfaces& surfaces, Generation& generation);

}  // namespace crsh::surfaces
