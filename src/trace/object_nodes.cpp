#include "trace/object_nodes.h"

namespace crsh::trace {

void run_object_nodes(gpu::Recorder& recorder, const In& in, const Segments& segments, ObjectNodesScratch& scratch) {
  const Bundle& bundle = in.workspace.bundle;
  for (const size_t s : segments) {
    const uint32_t kind = in.batch.segments[s].kind;
    const traversal::In nodes = traversal_in(in, kind);
    intersection::intersect_nodes(
        recorder, {intersection_in(in, kind), nodes, in.structures.objects, bundle.sorted_rays, bundle.order.order}, s,
        scratch.nodes, scratch.rays);
  }
}

}  // namespace crsh::trace
