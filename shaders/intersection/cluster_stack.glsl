// The stack of a cluster of lanes that walk a node together. It lies in registers, spread over the lanes, because on
// lavapipe each lane's access to memory takes time and arithmetic hardly any. Lane place % cluster has entry `place`.

const uint stack_rows = 4u;
#ifdef CRSH_NO_SHUFFLE
const uint max_stack = max_object_depth + 2u;
uvec2 stack_entries[max_stack];

void put_on_stack(uint place, uint visit, float enter) { stack_entries[place] = uvec2(visit, floatBitsToUint(enter)); }
uint stack_visit(uint place) { return stack_entries[place].x; }
float stack_enter(uint place) { return uintBitsToFloat(stack_entries[place].y); }
#else
const uint max_stack = stack_rows * cluster;
uvec4 stack_visits;
vec4 stack_enters;

void put_on_stack(uint place, uint visit, float enter) {
  bool here = place % cluster == lane_in_cluster();
  bvec4 row = equal(uvec4(0u, 1u, 2u, 3u), uvec4(here ? place / cluster : stack_rows));
  stack_visits = mix(stack_visits, uvec4(visit), row);
  stack_enters = mix(stack_enters, vec4(enter), row);
}

uint stack_visit(uint place) {
  uint row = place / cluster;
  uint visit = row == 0u ? stack_visits.x : row == 1u ? stack_visits.y : row == 2u ? stack_visits.z : stack_visits.w;
  return FROM_LANE(visit, first_of_cluster() + place % cluster);
}

float stack_enter(uint place) {
  uint row = place / cluster;
  float enter = row == 0u ? stack_enters.x : row == 1u ? stack_enters.y : row == 2u ? stack_enters.z : stack_enters.w;
  return FROM_LANE(enter, first_of_cluster() + place % cluster);
}
#endif
