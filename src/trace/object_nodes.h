#pragma once
// Nodes of rays through the object hierarchy (sections 3.2.5 and 3.2.6, and the paper's future work).

#include "intersection/nodes.h"
#include "trace/in.h"

namespace crsh::trace {

struct ObjectNodesScratch {
  intersection::NodeScratch nodes;
  intersection::SingleScratch rays;  ///< of nodes that gave up
};

void run_object_nodes(gpu::Recorder& recorder, const In& in, const Segments& segments, ObjectNodesScratch& scratch);

}  // namespace crsh::trace
