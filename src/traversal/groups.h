#pragma once
// Groups of ray nodes through the top of the object hierarchy (section 3.2.5, and the paper's future work).

#include "objects/hierarchy.h"
#include "traversal/traversal.h"

namespace crsh::traversal {

/// Makes `frontiers` hold those of the level-2 nodes `groups`, one after the other (shaders/shared/walk.h). Records,
/// may submit.
void walk_groups(gpu::Recorder& recorder, const In& in, const objects::Hierarchy& objects, hierarchy::Range groups,
                 gpu::Buffer& frontiers);

/// Makes `frontiers` hold a single one: the root's two children. For nodes without groups.
void start_at_root(gpu::Recorder& recorder, gpu::Buffer& frontiers);

}  // namespace crsh::traversal
