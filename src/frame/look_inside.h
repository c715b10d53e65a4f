#pragma once
// Reads what a frame built off the device.

#include <vector>

#include "crsh/built.h"
#include "frame/state.h"

namespace crsh {

/// Appends the nodes of state.batch, of generation `bounce`, whose rays begin at `first_ray` of the table.
void dump_nodes(Renderer::State& state, uint32_t bounce, uint32_t first_ray, std::vector<RayNode>& nodes);

/// The boxes down to this depth; none where the algorithm has no object hierarchy. Submits and waits.
[[nodiscard]] std::vector<ObjectBox> object_boxes(Renderer::State& state, uint32_t depth);

}  // namespace crsh
