#pragma once
// Rays one by one through the object hierarchy: what anybody would write, and the one to beat.

#include "intersection/intersection.h"
#include "objects/hierarchy.h"

namespace crsh::intersection {

/// Lists of rays that need very many tests; kept between calls.
struct SingleScratch {
  gpu::Buffer left;        ///< uint: these rays, counted from the segment's first one, in any order
  gpu::Buffer count;       ///< one uint: how many have not ended
  gpu::Buffer still_left;  ///< uint: those of `left` that need yet more
  gpu::Buffer states, stacks;
};

/// The rays of one segment, in creation order, against the scene that `objects` was built over. Submits, and waits.
void intersect_single(gpu::Recorder& recorder, const In& in, const objects::Hierarchy& objects,
                      const rays::Segment& segment, SingleScratch& scratch);

/// Makes room in `left` and `count` for a segment, for those who leave some of its rays to intersect_left().
void reserve(gpu::Recorder& recorder, const rays::Segment& segment, SingleScratch& scratch);
/// The rays of the segment that are listed in `left`; `count` is their number. Submits, and waits.
void intersect_left(gpu::Recorder& recorder, const In& in, const objects::Hierarchy& objects,
                    const rays::Segment& segment, SingleScratch& scratch);

}  // namespace crsh::intersection
