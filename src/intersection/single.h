#pragma once
// Single rays: each walks through the object hierarchy by itself, as in common ray tracers. This is what ray nodes are
// compared with.

#include "intersection/intersection.h"
#include "objects/hierarchy.h"

namespace crsh::intersection {

/// Lists of rays that need very many tests; kept between calls.
struct SingleScratch {
  gpu::Buffer unfinished;        ///< uint: how many there are; then these rays, counted from the segment's first one
  gpu::Buffer still_unfinished;  ///< the same of those of `unfinished` that need yet more
  gpu::Buffer walking;           ///< one uint: rays that are walked in pieces and have not ended
  gpu::Buffer states, stacks;
};

/// Traces the rays of one segment, in creation order, through the hierarchy `objects`. Submits, and waits.
void intersect_single(gpu::Recorder& recorder, const In& in, const objects::Hierarchy& objects,
                      const rays::Segment& segment, SingleScratch& scratch);

/// Makes room in `unfinished` for a segment and empties it, for those who leave some of its rays to
/// intersect_unfinished().
void begin_left(gpu::Recorder& recorder, const rays::Segment& segment, SingleScratch& scratch);
/// The rays of the segment that are listed in `unfinished`. Submits, and waits.
void intersect_unfinished(gpu::Recorder& recorder, const In& in, const objects::Hierarchy& objects,
                          const rays::Segment& segment, SingleScratch& scratch);

}  // namespace crsh::intersection
