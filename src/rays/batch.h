#pragma once
// A batch: rays of one bounce that are sorted and bundled together, of one kind or of several.

#include <cstdint>
#include <vector>

#include "crsh/kinds.h"
#include "gpu/buffer.h"

namespace crsh::rays {

/// A run of rays of one kind (and one light, where there is one a light). Nodes never cross its ends, so that counters
/// do not depend on what else is in the batch.
struct Segment {
  uint32_t kind = 0;              ///< shared::kind_*
  uint32_t light = 0;             ///< where there is one a light: its index
  uint32_t first = 0, count = 0;  ///< rays, in creation order after trimming; sorting keeps the segment's place
  bool shares_origin = ray_kinds[kind].shares_origin;  ///< all begin at one place
};

/// Slots: one a surface a segment, segment-major: slot = segment * surfaces + surface.
struct Batch {
  gpu::Buffer rays;   ///< shared::Ray a ray, in creation order, trimmed
  gpu::Buffer slots;  ///< uint a ray: the slot it came from
  /// uint a slot: inclusive scan of the head flags; slot s holds ray ends[s] - 1 where ends[s] > ends[s-1]
  gpu::Buffer ends;
  gpu::Buffer given_keys;   ///< uint a ray: keys from a file, where there are any
  uint32_t given_bits = 0;  ///< of those keys
  std::vector<Segment> segments;
  uint32_t surfaces = 0;  ///< slots a segment
  uint32_t count = 0;     ///< rays
};

}  // namespace crsh::rays
