#include "trace/trace.h"

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

using Need = bool Needs::*;

/// Whether rays go to a tracer that needs this.
bool is_needed(const Traced& traced, Need what) {
  for (size_t s = 0; s < traced.tracers.size(); ++s)
    if (traced.in.batch.segments[s].count && traced.tracers[s]->needs.*what) return true;
  return false;
}

/// By segment.
std::vector<bool> without_nodes(const Traced& traced) {
  std::vector<bool> without;
  for (const Tracer* tracer : traced.tracers) without.push_back(!tracer->needs.sorted_rays);
  return without;
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
  if (is_needed(traced, &Needs::sorted_rays)) {
    traced.bundle = &workspace.bundle;
    bundle(recorder, in, without_nodes(traced), workspace.bundle);
  }
  workspace.account.begin(recorder, in.wanted, in.batch.count, traced.hierarchy());
  if (is_needed(traced, &Needs::empty_hits)) intersection::clear(recorder, in.batch, workspace.hits);
  for (const Tracer& tracer : tracers())
    if (const Segments segments = segments_of(traced, tracer); !segments.empty()) run(recorder, in, tracer, segments);
  return traced;
}

}  // namespace crsh::trace
