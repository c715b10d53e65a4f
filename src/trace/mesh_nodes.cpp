#include "trace/mesh_nodes.h"

namespace crsh::trace {
namespace {

/// The nodes of a batch that are traversed together: those of one kind on its top level.
hierarchy::Range nodes_of(const In& in, const Segments& segments, uint32_t kind, uint32_t depth) {
  const hierarchy::Hierarchy& hierarchy = in.workspace.bundle.hierarchy;
  hierarchy::Range range;
  if (depth > hierarchy.depth) return range;
  for (const size_t s : segments) {
    if (in.batch.segments[s].kind != kind) continue;
    const hierarchy::Range nodes = hierarchy.levels[depth - 1].segments[s];
    if (range.count == 0) range.first = nodes.first;
    range.count += nodes.count;
  }
  return range;
}

void trace_kind(gpu::Recorder& recorder, const In& in, const Segments& segments, uint32_t kind,
                MeshNodesScratch& scratch) {
  const Bundle& bundle = in.workspace.bundle;
  const uint32_t depth = in.options.algorithm.levels[kind];
  const hierarchy::Range top = nodes_of(in, segments, kind, depth);
  const traversal::In nodes = traversal_in(in, kind);
  const intersection::In rays = intersection_in(in, kind);
  traversal::traverse(recorder, nodes, depth, top, scratch, [&](const traversal::Candidates& candidates) {
    intersection::intersect(recorder, rays, bundle.hierarchy, bundle.sorted_rays, bundle.order.order, candidates);
  });
}

}  // namespace

void run_mesh_nodes(gpu::Recorder& recorder, const In& in, const Segments& segments, MeshNodesScratch& scratch) {
  for (uint32_t kind = 0; kind < kind_count; ++kind) trace_kind(recorder, in, segments, kind, scratch);
}

}  // namespace crsh::trace
