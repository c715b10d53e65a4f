#include "trace/bundle.h"

#include "trace/in.h"

namespace crsh::trace {
namespace {

void sort(gpu::Recorder& recorder, const In& in, Bundle& out) {
  const AlgorithmOptions& options = in.options.algorithm;
  coherence::order(recorder, out.sort,
                   {.batch = in.batch,
                    .keys = options.keys,
                    .bounds = in.scene.bounds,
                    .compression = options.compression,
                    .unstable = in.options.mutation == "unstable-sort"},
                   out.order);
  coherence::gather(recorder, in.batch, out.order, out.sorted_rays);
}

/// Above level 1 nodes are cut only as groups for the object hierarchy: others are tested against the whole scene, and
/// there would be too many of them.
void build_nodes(gpu::Recorder& recorder, const In& in, std::vector<bool> without_nodes, Bundle& out) {
  const AlgorithmOptions& options = in.options.algorithm;
  hierarchy::build(recorder,
                   {.sorted_rays = out.sorted_rays,
                    .segments = in.batch.segments,
                    .options = options,
                    .narrow_cones = in.options.mutation == "narrow-cones",
                    .extent = in.scene.bounds.longest_edge(),
                    .cut_groups = tracer_of(options).needs.object_hierarchy,
                    .without_nodes = std::move(without_nodes)},
                   out.hierarchy);
}

}  // namespace

void bundle(gpu::Recorder& recorder, const In& in, std::vector<bool> without_nodes, Bundle& out) {
  sort(recorder, in, out);
  build_nodes(recorder, in, std::move(without_nodes), out);
}

}  // namespace crsh::trace
