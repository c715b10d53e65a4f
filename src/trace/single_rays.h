#pragma once
// Rays one by one through the object hierarchy.

#include "intersection/single.h"
#include "trace/in.h"

namespace crsh::trace {

using SingleRaysScratch = intersection::SingleScratch;

void run_single_rays(gpu::Recorder& recorder, const In& in, const Segments& segments, SingleRaysScratch& scratch);

}  // namespace crsh::trace
