// The stack of a cluster of lanes that walk a node together. It lies in registers, spread over the lanes, because on
// lavapipe each lane's access to memory takes time and arithmetic hardly any. Lane place % cluster has entry `place`.

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
