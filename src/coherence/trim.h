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

/// Collects the rays of `sparse_rays` (a shared::Ray a slot), where `flags` (a uint a slot, quad_bytes of all slots) is
/// 1 and not 0: fills rays, slots, ends and count of `out`, and each segment's first and count. On entry `out` has its
/// segments, with kind and light, and `surfaces`: the slots of a segment. Submits, and waits for the counts.
void trim(gpu::Recorder& recorder, TrimScratch& scratch, const gpu::Buffer& sparse_rays, const gpu::Buffer& flags,
          rays::Batch& out);

}  // namespace crsh::coherence
