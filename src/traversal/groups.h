#pragma once
// Groups, nodes of level 2, walk through the top of the object hierarchy (section 3.2.5, and the paper's future work).

#include "objects/hierarchy.h"
#include "traversal/traversal.h"

namespace crsh::traversal {

/// Fills `frontiers` with the frontiers of these groups, one after the other (shaders/shared/walk.h). Records, and may
/// submit.
void walk_groups(gpu::Recorder& recorder, const In& in, const objects::Hierarchy& objects, hierarchy::Range groups,
                 gpu::Buffer& frontiers);

/// Fills `frontiers` with a single one, the root's two children: for nodes without groups.
void start_at_root(gpu::Recorder& recorder, gpu::Buffer& frontiers);

}  // namespace crsh::traversal
