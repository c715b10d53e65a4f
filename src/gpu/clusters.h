#pragma once
// Clusters of neighbouring lanes that pass values between them (shaders/lib/cluster.glsl).

#include "gpu/device.h"

namespace crsh::gpu {

/// Lanes of a workgroup in kernels with clusters.
inline constexpr uint32_t cluster_workgroup = 64;

/// Whether kernels may have clusters of so many lanes, a power of two: subgroups must be full (program.h), and hold
/// whole clusters.
[[nodiscard]] inline bool may_cluster(const Device& device, uint32_t lanes) {
  const uint32_t subgroup = device.info().subgroup_size;
  return device.may_shuffle() && cluster_workgroup % subgroup == 0 && lanes <= subgroup;
}

}  // namespace crsh::gpu
