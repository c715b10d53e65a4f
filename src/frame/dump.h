#pragma once
// Takes the rays of a batch off the device once they are traced.

#include "crsh/ray_table.h"
#include "trace/trace.h"

namespace crsh {

/// Appends the rays of the batch to `table` with their keys, places and hits. Submits and waits.
void dump_rays(gpu::Recorder& recorder, const trace::Traced& traced, RayTable& table);

}  // namespace crsh
