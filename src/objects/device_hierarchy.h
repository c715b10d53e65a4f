#pragma once
// The device's own hierarchy over all drawn triangles, where it has ray queries.

#include <memory>
#include <vector>

#include "gpu/acceleration.h"
#include "objects/hierarchy.h"

namespace crsh::objects {

struct DeviceHierarchy {
  gpu::Buffer corners;                                    ///< three vec4 a triangle
  std::unique_ptr<gpu::AccelerationStructure> structure;  ///< none over no triangles
  scene::GeometryPose pose;                               ///< when it was built
  uint32_t builds = 0;
};

/// Throws UserError where the device has no ray queries.
void require_ray_queries(const gpu::Device& device);

/// Builds it where there is none, and anew where objects have moved or deformed since. (Stage: object hierarchy.)
void update(gpu::Recorder& recorder, const In& in, DeviceHierarchy& hierarchy);

}  // namespace crsh::objects
