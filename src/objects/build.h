#pragma once
// Parallel locally-ordered clustering (Meister and Bittner, "Parallel Locally-Ordered Clustering for Bounding Volume
// Hierarchy Construction", 2018), numbered from the root as in PLOC++ (Benthin, Drabinski, Tessari, Dittebrandt 2022).

#include "objects/hierarchy.h"

namespace crsh::objects {

/// Builds all of `hierarchy` but its boxes, its cost and its leaf order's corners, which fit() makes. The same scene
/// gives the same tree, bit for bit, whatever the subgroup's size.
void build_tree(gpu::Recorder& recorder, const In& in, Hierarchy& hierarchy);

}  // namespace crsh::objects
