#include "trace/ray_query.h"

#include "intersection/ray_query.h"

namespace crsh::trace {

void run_ray_query(gpu::Recorder& recorder, const In& in, const Segments& segments, NoScratch&) {
  for (const size_t s : segments) {
    const rays::Segment& segment = in.batch.segments[s];
    intersection::query(recorder, intersection_in(in, segment.kind), in.structures.device_objects, in.structures.plain,
                        segment);
  }
}

}  // namespace crsh::trace
