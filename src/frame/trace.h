#pragma once
// Step 1 and steps 4 to 6 of Figure 1: what frames and replayed rays share.

#include "frame/state.h"

namespace crsh {

/// Step 1 (section 3.2.1): objects, their bounds and the hierarchy over them as they stand in this pose.
void place_objects(Renderer::State& state, const scene::Pose& pose);

/// What meets the scene: as the options say, but single rays in place of nodes where the object hierarchy holds so
/// little, or all rays of the batch are so scattered, that sorting would cost more than it saves.
[[nodiscard]] Tracing tracing_of(const Renderer::State& state);

/// Whose rays a batch holds: the pixel and path of each slot's surface, as surfaces::Surfaces have them.
struct RayNames {
  const gpu::Buffer& pixels;   ///< vec4 a surface, w: bits of the pixel
  const gpu::Buffer& paths;    ///< vec4 a surface, w: bits of the path
  uint32_t first_surface = 0;  ///< of the batch: slot 0 of each segment
};

/// Sorts, bundles and traces the rays of state.batch.rays, of generation `bounce`; their hits are then in
/// state.batch.hits, their counts in state.frame_statistics and on the device.
void trace(Renderer::State& state, uint32_t bounce, const RayNames& names);

}  // namespace crsh
