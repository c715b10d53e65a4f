#include "trace/single_rays.h"

namespace crsh::trace {

void run_single_rays(gpu::Recorder& recorder, const In& in, const Segments& segments, SingleRaysScratch& scratch) {
  for (const size_t s : segments) {
    const rays::Segment& segment = in.batch.segments[s];
    intersection::intersect_single(recorder, intersection_in(in, segment.kind), in.structures.objects, segment,
                                   scratch);
  }
}

}  // namespace crsh::trace
