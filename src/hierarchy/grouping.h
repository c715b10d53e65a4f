#pragma once
// Which children make a node: every `arity` of them, or as many as are coherent.

#include "hierarchy/hierarchy.h"

namespace crsh::hierarchy {

/// How far a ray may be from the first one of a cut node (shaders/hierarchy/goes_along.glsl): the chord between their
/// directions on the unit sphere, and the distance of their origins, metres.
struct CutLimits {
  float chord, reach;
};
/// The limits for nodes of levels[index]; `extent` is the longest edge of the scene's bounds, metres.
[[nodiscard]] CutLimits cut_limits(const AlgorithmOptions& options, float extent, uint32_t index);

/// Levels that the rays of the `s`th segment get.
[[nodiscard]] uint32_t wanted_levels(const In& in, size_t s);

/// Groups the children in `below` (a range a segment: rays for index 0, else nodes of level index - 1) into the nodes
/// of out.levels[index], which gets its counts, ranges and parents; bounds are not filled. Where nodes are cut, submits
/// and waits for their number.
void group(gpu::Recorder& recorder, const In& in, const std::vector<Range>& below, uint32_t index, Hierarchy& out);

}  // namespace crsh::hierarchy
