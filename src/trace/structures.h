#pragma once
// Step 1 of Figure 1 (section 3.2.1): what is built over the objects, for rays to be traced through.

#include "objects/device_hierarchy.h"
#include "objects/hierarchy.h"
#include "trace/tracers.h"

namespace crsh::trace {

struct Structures {
  objects::Hierarchy objects;               ///< as place() left it; empty until a tracer needs it
  objects::DeviceHierarchy device_objects;  ///< the device's own, likewise
  bool plain = false;                       ///< every triangle of the scene blocks, from either side
};

/// Brings what is needed up to date with the scene as it stands now, and leaves the rest as it is. May submit and wait.
void place(gpu::Recorder& recorder, const objects::In& in, const Needs& needs, Structures& structures);

}  // namespace crsh::trace
