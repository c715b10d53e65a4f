#pragma once
// Step 1 and steps 4 to 6 of Figure 1: what frames and replayed rays share.

#include "frame/state.h"

namespace crsh {

/// Step 1 (section 3.2.1): moves objects, their bounds and the hierarchy over them to this pose.
void place_objects(Renderer::State& state, const scene::Pose& pose);

/// Steps 4 to 6: sorts, bundles and traces the rays of state.batch.rays, of generation `bounce`. Their hits are then in
/// state.batch.tracing, their counts in state.frame_statistics and on the device.
void trace_rays(Renderer::State& state, uint32_t bounce, const trace::RayNames& names);

}  // namespace crsh
