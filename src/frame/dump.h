#pragma once
// Reads the rays of a batch from the device once they are traced.

#include "crsh/ray_table.h"
#include "trace/trace.h"

namespace crsh {

/// Appends the rays of the batch to `table` with their keys, places and hits. Submits and waits.
void dump_rays(gpu::Recorder& recorder, const trace::Traced& traced, RayTable& table);

}  // namespace crsh
