#pragma once
// Traces rays with the device's own ray queries (VK_KHR_ray_query), where it has them.

#include "intersection/intersection.h"
#include "objects/device_hierarchy.h"

namespace crsh::intersection {

/// Traces the rays of one segment. `plain`: every triangle of the scene blocks, from either side. Counts nothing,
/// because nobody can know what the device tests.
void query(gpu::Recorder& recorder, const In& in, const objects::DeviceHierarchy& objects, bool plain,
           const rays::Segment& segment);

}  // namespace crsh::intersection
