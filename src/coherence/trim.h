#pragma once
// Trimming: from slots of which some hold a ray to an array of rays (section 3.2.2, Figure 4).

#include <cstdint>

#include "gpu/recorder.h"
#include "primitives/scan.h"
#include "rays/batch.h"

namespace crsh::coherence {

/// What trimming needs besides its arrays, kept between calls.
struct TrimScratch {
  primitives::ScanScratch scan;
  gpu::Buffer segment_ends;
};

/// Fills rays, slots, ends, count and each segment's first and count of `out` from `sparse_rays` (a shared::Ray a slot)
/// and the head `flags` (a uint a slot, 1 where there is a ray, else 0; quad_bytes of all slots). On entry `out` has
/// its segments (kind and light) and `surfaces`: slots, segment-major. Submits and waits for the counts.
void trim(gpu::Recorder& recorder, TrimScratch& scratch, const gpu::Buffer& sparse_rays, const gpu::Buffer& flags,
          rays::Batch& out);

}  // namespace crsh::coherence
