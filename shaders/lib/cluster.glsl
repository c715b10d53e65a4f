#ifndef CRSH_LIB_CLUSTER_GLSL
#define CRSH_LIB_CLUSTER_GLSL
// A cluster of lanes that walk together: so many as the includer's `cluster` says, a power of two; one in "-alone"
// builds. What all of them know they find out by shuffles alone: on lavapipe a ballot takes as long as ten.

#include "lib/invocation.glsl"
#include "lib/together.glsl"

#ifdef CRSH_ALONE
uint lane_in_cluster() { return 0u; }
uint first_of_cluster() { return 0u; }
/// A bit for each lane of the cluster where `value` holds.
uint lanes_of_cluster(bool value) { return value ? 1u : 0u; }
/// Lanes of a cluster have neighbouring places.
uint lane_place() { return invocation_index(); }
/// Inclusive, up to this lane of the cluster.
uint sum_of_lanes(uint value) { return value; }
/// The first lane whose inclusive sum is above `place`.
uint lane_of_sum(uint sum, uint place) { return 0u; }
/// Of all lanes of the cluster.
uint least_of_lanes(uint value) { return value; }
float largest_of_lanes(float value) { return value; }
#else
uint lane_in_cluster() { return gl_SubgroupInvocationID & (cluster - 1u); }
uint first_of_cluster() { return gl_SubgroupInvocationID & ~(cluster - 1u); }
uint lanes_of_cluster(bool value) {
  uint bits = value ? 1u << lane_in_cluster() : 0u;
  for (uint apart = 1u; apart < cluster; apart <<= 1u) bits |= FROM_LANE(bits, gl_SubgroupInvocationID ^ apart);
  return bits;
}
uint sum_of_lanes(uint value) {
  for (uint apart = 1u; apart < cluster; apart <<= 1u) {
    uint before = FROM_LANE(value, gl_SubgroupInvocationID - min(apart, lane_in_cluster()));
    value += lane_in_cluster() >= apart ? before : 0u;
  }
  return value;
}
uint lane_of_sum(uint sum, uint place) {
  uint lane = 0u;
  for (uint k = 0u; k + 1u < cluster; ++k) lane += FROM_LANE(sum, first_of_cluster() + k) <= place ? 1u : 0u;
  return lane;
}
uint least_of_lanes(uint value) {
  for (uint apart = 1u; apart < cluster; apart <<= 1u)
    value = min(value, FROM_LANE(value, gl_SubgroupInvocationID ^ apart));
  return value;
}
float largest_of_lanes(float value) {
  for (uint apart = 1u; apart < cluster; apart <<= 1u)
    value = max(value, FROM_LANE(value, gl_SubgroupInvocationID ^ apart));
  return value;
}
/// Subgroups are full: the host asks for this build only where they divide a workgroup.
uint lane_place() {
  return workgroup_index() * gl_WorkGroupSize.x + gl_SubgroupID * gl_SubgroupSize + gl_SubgroupInvocationID;
}
#endif

uint cluster_place() { return lane_place() / cluster; }

#endif
