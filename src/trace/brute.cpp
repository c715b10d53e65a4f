#include "trace/brute.h"

namespace crsh::trace {

void run_brute(gpu::Recorder& recorder, const In& in, const Segments& segments, NoScratch&) {
  for (const size_t s : segments) {
    const rays::Segment& segment = in.batch.segments[s];
    intersection::intersect_all(recorder, intersection_in(in, segment.kind), segment);
  }
}

}  // namespace crsh::trace
