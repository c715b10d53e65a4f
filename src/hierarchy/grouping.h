#pragma once
// Which children make a node: every so many of them, or as far as their rays are coherent.

#include "hierarchy/hierarchy.h"

namespace crsh::hierarchy {

/// Levels that a segment's rays get.
[[nodiscard]] uint32_t wanted_levels(const rays::Segment& segment, const AlgorithmOptions& options);

/// Groups the children in `below` (a range a segment: rays for index 0, else nodes of level index - 1) into the nodes of
/// out.levels[index], which gets its counts, ranges and parents; bounds are not filled. Where nodes are cut, submits and
/// waits for their number.
void group(gpu::Recorder& recorder, const In& in, const std::vector<Range>& below, uint32_t index, Hierarchy& out);

}  // namespace crsh::hierarchy
