#pragma once
// Section 3.2.6: exact tests of rays against candidate triangles, or against all.

#include <cstdint>

#include "gpu/buffer.h"
#include "gpu/recorder.h"
#include "hierarchy/account.h"
#include "hierarchy/hierarchy.h"
#include "rays/batch.h"
#include "scene/device/upload.h"
#include "traversal/traversal.h"

namespace crsh::intersection {

struct In {
  const scene::GpuScene& scene;
  const rays::Batch& batch;
  const gpu::Buffer& hits;      ///< shared::Hit a ray, in creation order
  const gpu::Buffer& counters;  ///< uvec2, 64 bits each
  uint32_t counter_row = 0;     ///< first counter of this bounce and kind
  uint64_t submit_work = 0;     ///< tests a submit
  const hierarchy::Account& account = hierarchy::no_account;
};

/// Sets the hits of all rays of the batch to "none yet".
void clear(gpu::Recorder& recorder, const rays::Batch& batch, const gpu::Buffer& hits);

/// Tests the rays of the candidates' nodes against the candidates' triangles. `sorted_rays` and `order` are by sorted
/// position.
void intersect(gpu::Recorder& recorder, const In& in, const hierarchy::Hierarchy& hierarchy,
               const gpu::Buffer& sorted_rays, const gpu::Buffer& order, const traversal::Candidates& candidates);

/// Tests the rays of one segment against every triangle of the scene.
void intersect_all(gpu::Recorder& recorder, const In& in, const rays::Segment& segment);

/// Adds a segment's hits and digest to its counters (crsh-stats: hits, hits_digest). `pixels` and `paths` are the
/// surfaces' diffuse and specular buffers, whose w hold pixel and path; slot 0 of each segment belongs to surface
/// `first_surface`.
void digest(gpu::Recorder& recorder, const In& in, const rays::Segment& segment, uint32_t first_surface,
            const gpu::Buffer& pixels, const gpu::Buffer& paths);

}  // namespace crsh::intersection
