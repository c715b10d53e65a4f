#include "trace/trace.h"

#include <algorithm>

#include "primitives/grow.h"
#include "shared/ray.h"
#include "trace/choose.h"

namespace crsh::trace {
namespace {

/// The segments with rays that this tracer gets.
Segments segments_of(const Traced& traced, const Tracer& tracer) {
  Segments numbers;
  for (size_t s = 0; s < traced.tracers.size(); ++s)
    if (traced.tracers[s] == &tracer && traced.in.batch.segments[s].count) numbers.push_back(s);
  return numbers;
}

/// Sorts and bundles the rays where a tracer needs that.
void bundle_if_needed(gpu::Recorder& recorder, Traced& traced) {
  std::vector<bool> without_nodes;
  bool any = false;
  for (size_t s = 0; s < traced.tracers.size(); ++s) {
    without_nodes.push_back(!traced.tracers[s]->needs.sorted_rays);
    any |= !without_nodes.back() && traced.in.batch.segments[s].count;
  }
  if (!any) return;
  traced.bundle = &traced.in.workspace.bundle;
  bundle(recorder, traced.in, std::move(without_nodes), *traced.bundle);
}

}  // namespace

const hierarchy::Hierarchy& Traced::hierarchy() const {
  static const hierarchy::Hierarchy none;
  return bundle ? bundle->hierarchy : none;
}

Traced trace(gpu::Recorder& recorder, const In& in) {
  Workspace& workspace = in.workspace;
  primitives::grow(recorder, workspace.hits, uint64_t(in.batch.count) * sizeof(shared::Hit), "hits");
  Traced traced{.in = in, .tracers = choose_tracers(recorder, in)};
  bundle_if_needed(recorder, traced);
  workspace.account.begin(recorder, in.wanted, in.batch.count, traced.hierarchy());
  for (const Tracer& tracer : tracers())
    if (const Segments segments = segments_of(traced, tracer); !segments.empty()) run(recorder, in, tracer, segments);
  return traced;
}

}  // namespace crsh::trace
