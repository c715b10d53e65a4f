#pragma once
// Takes the rays of a batch off the device once they are traced.

#include "frame/trace.h"

namespace crsh {

/// Appends the rays of state.batch.rays, of generation `bounce`, to `table` with their keys, places and hits.
void dump_batch(Renderer::State& state, uint32_t bounce, const RayNames& names, RayTable& table);

}  // namespace crsh
