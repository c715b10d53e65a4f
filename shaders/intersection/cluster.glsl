// The cluster of lanes that walk a node together, and its stack. The stack's first entries lie in registers, spread over
// the lanes: lavapipe pays for memory by the lane, and hardly for arithmetic.

#ifdef CRSH_ALONE
uint lane_in_cluster() { return 0u; }
uint first_of_cluster() { return 0u; }
/// A bit for each lane of the cluster where `value` holds.
uint lanes_of_cluster(bool value) { return value ? 1u : 0u; }
uint node_place() { return invocation_index(); }
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
  for (uint apart = 1u; apart < cluster; apart <<= 1u) value = min(value, FROM_LANE(value, gl_SubgroupInvocationID ^ apart));
  return value;
}
float largest_of_lanes(float value) {
  for (uint apart = 1u; apart < cluster; apart <<= 1u) value = max(value, FROM_LANE(value, gl_SubgroupInvocationID ^ apart));
  return value;
}
/// Subgroups are full: the host asks for this build only where they divide a workgroup.
uint node_place() {
  return (workgroup_index() * gl_WorkGroupSize.x + gl_SubgroupID * gl_SubgroupSize + gl_SubgroupInvocationID) / cluster;
}
#endif

// The stack: entry `place` lies in the registers of lane place % cluster.
const uint held_rows = 4u;
#ifdef CRSH_ALONE
const uint most_held = max_object_depth + 2u;
uvec2 held[most_held];

void hold(uint place, uint visit, float enter) { held[place] = uvec2(visit, floatBitsToUint(enter)); }
uint held_visit(uint place) { return held[place].x; }
float held_enter(uint place) { return uintBitsToFloat(held[place].y); }
#else
const uint most_held = held_rows * cluster;
uvec4 held_visits;
vec4 held_enters;

void hold(uint place, uint visit, float enter) {
  bool here = place % cluster == lane_in_cluster();
  bvec4 row = equal(uvec4(0u, 1u, 2u, 3u), uvec4(here ? place / cluster : held_rows));
  held_visits = mix(held_visits, uvec4(visit), row);
  held_enters = mix(held_enters, vec4(enter), row);
}

uint held_visit(uint place) {
  uint row = place / cluster;
  uint visit = row == 0u ? held_visits.x : row == 1u ? held_visits.y : row == 2u ? held_visits.z : held_visits.w;
  return FROM_LANE(visit, first_of_cluster() + place % cluster);
}

float held_enter(uint place) {
  uint row = place / cluster;
  float enter = row == 0u ? held_enters.x : row == 1u ? held_enters.y : row == 2u ? held_enters.z : held_enters.w;
  return FROM_LANE(enter, first_of_cluster() + place % cluster);
}
#endif
