#pragma once
// Direct light from the shadow rays of a batch.

#include "gpu/recorder.h"
#include "rays/create.h"
#include "scene/device/upload.h"
#include "surfaces/surfaces.h"

namespace crsh::shading {

struct DirectIn {
  const surfaces::Surfaces& surfaces;
  const scene::GpuScene& scene;
  const rays::BatchPlan& plan;
  const gpu::Buffer& ends;  ///< of the batch
  const gpu::Buffer& hits;  ///< shared::Hit a ray, in creation order
};

/// Adds what the batch's rays to lights let through to `generation.direct`, light by light.
void add_direct(gpu::Recorder& recorder, const DirectIn& in, surfaces::Generation& generation);

/// Adds visibility and number of the batch's rays of one any-hit kind to their pixels: vec4, x and y.
void add_visibility(gpu::Recorder& recorder, const DirectIn& in, uint32_t kind, const gpu::Buffer& pixels);

}  // namespace crsh::shading
