#pragma once
// Ray nodes walk through the object hierarchy: level-1 nodes from their groups' frontiers down to the leaves, where
// their rays are tested against triangles. The rays of nodes that need too many tests go one by one. (Sections 3.2.5
// and 3.2.6, and the paper's future work.)

#include "intersection/single.h"
#include "traversal/groups.h"

namespace crsh::intersection {

/// Kept between calls.
struct NodeScratch {
  gpu::Buffer frontiers;
};

/// Of the rays, whose hits are written, and of the nodes over them.
struct NodesIn : In {
  const traversal::In& traversal;
  const objects::Hierarchy& objects;       ///< over the scene as it is now
  const gpu::Buffer &sorted_rays, &order;  ///< by sorted position
};

/// All rays of the batch's segment. Submits, and waits.
void intersect_nodes(gpu::Recorder& recorder, const NodesIn& in, size_t segment, NodeScratch& scratch,
                     SingleScratch& single);

}  // namespace crsh::intersection
