#pragma once
// Which children make a node: every so many of them, or as far as their rays are coherent.

#include "hierarchy/hierarchy.h"

namespace crsh::hierarchy {

/// How far apart the rays of a cut node may be: as shaders/hierarchy/goes_along.glsl takes it.
struct CutLimits {
  float chord, reach;
};
/// Of the nodes of levels[index]; `extent` is the longest edge of the scene's bounds, metres.
[[nodiscard]] CutLimits cut_limits(const AlgorithmOptions& options, float extent, uint32_t index);

/// Levels that the rays of the `s`th segment get.
[[nodiscard]] uint32_t wanted_levels(const In& in, size_t s);

/// Groups the children in `below` (a range a segment: rays for index 0, else nodes of level index - 1) into the nodes
/// of out.levels[index], which gets its counts, ranges and parents; bounds are not filled. Where nodes are cut, submits
/// and waits for their number.
void group(gpu::Recorder& recorder, const In& in, const std::vector<Range>& below, uint32_t index, Hierarchy& out);

}  // namespace crsh::hierarchy
