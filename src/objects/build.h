#pragma once
// Parallel locally-ordered clustering (Meister and Bittner, "Parallel Locally-Ordered Clustering for Bounding Volume
// Hierarchy Construction", 2018), numbered from the root as in PLOC++ (Benthin, Drabinski, Tessari, Dittebrandt 2022).

#include "objects/hierarchy.h"

namespace crsh::objects {

/// Builds the tree and the order of its leaves. Boxes, cost and the corners in leaf order are left to fit(). The same
/// scene gives the same tree, bit for bit, whatever the subgroup's size.
void build_tree(gpu::Recorder& recorder, const In& in, Hierarchy& hierarchy);

}  // namespace crsh::objects
