#pragma once
// Reads from the device what a frame built: nodes and boxes.

#include <vector>

#include "crsh/built.h"
#include "trace/trace.h"

namespace crsh {

/// Appends the nodes of a batch whose rays begin at `first_ray` of the table. Submits and waits where there are any.
void dump_nodes(gpu::Recorder& recorder, const trace::Traced& traced, uint32_t first_ray, std::vector<RayNode>& nodes);

/// The boxes down to this depth. Submits and waits.
[[nodiscard]] std::vector<ObjectBox> object_boxes(gpu::Recorder& recorder, const objects::Hierarchy& objects,
                                                  uint32_t depth);

}  // namespace crsh
