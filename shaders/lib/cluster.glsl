#ifndef CRSH_LIB_CLUSTER_GLSL
#define CRSH_LIB_CLUSTER_GLSL
// A cluster: neighbouring lanes of a subgroup that walk together. The includer's `cluster` is their number, a power of
// two, and 1 in "-no-shuffle" builds. They tell each other by shuffles only: on lavapipe a ballot takes as long as ten
// of them.

#include "lib/invocation.glsl"
#include "lib/shuffle_read.glsl"

#ifdef CRSH_NO_SHUFFLE
uint lane_in_cluster() { return 0u; }
uint first_of_cluster() { return 0u; }
/// A bit for each lane of the cluster where `value` holds.
uint lanes_of_cluster(bool value) { return value ? 1u : 0u; }
/// The lane's number in the dispatch, such that lanes of a cluster have consecutive ones.
uint lane_place() { return invocation_index(); }
/// Sum over the cluster's lanes up to this one, and with it.
uint sum_of_lanes(uint value) { return value; }
/// The first lane whose inclusive sum is above `place`.
uint lane_of_sum(uint sum, uint place) { return 0u; }
/// The least, and below the largest, over all lanes of the cluster.
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
/// Counts on full subgroups: the host uses this build only where subgroups divide a workgroup.
uint lane_place() {
  return workgroup_index() * gl_WorkGroupSize.x + gl_SubgroupID * gl_SubgroupSize + gl_SubgroupInvocationID;
}
#endif

uint cluster_place() { return lane_place() / cluster; }

#endif
