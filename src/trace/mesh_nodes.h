#pragma once
// Nodes of rays against all triangles, mesh by mesh and level by level, and rays against the candidates (sections 3.2.5
// and 3.2.6): the paper's way.

#include "trace/in.h"

namespace crsh::trace {

using MeshNodesScratch = traversal::Scratch;

void run_mesh_nodes(gpu::Recorder& recorder, const In& in, const Segments& segments, MeshNodesScratch& scratch);

}  // namespace crsh::trace
