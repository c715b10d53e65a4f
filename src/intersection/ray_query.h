#pragma once
// Rays by the device's own ray queries (VK_KHR_ray_query), where it has them.

#include "intersection/intersection.h"
#include "objects/device_hierarchy.h"

namespace crsh::intersection {

/// The rays of one segment. `plain`: every triangle of the scene blocks, from either side. Counts nothing: what the
/// device tests is its own affair.
void query(gpu::Recorder& recorder, const In& in, const objects::DeviceHierarchy& objects, bool plain,
           const rays::Segment& segment);

}  // namespace crsh::intersection
