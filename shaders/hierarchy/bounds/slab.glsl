// Node bound "slab": the ranges of its rays' origins, ends and directions, axis by axis. Against a box it is the ray's
// own slab test in interval arithmetic; against a triangle, the test of the triangle's box. Where a range of directions
// holds zero (its rays do not share an octant), that axis says little: cut nodes (--nodes cut) have none such.

#include "hierarchy/slab.glsl"

#define BOUND_TESTS_CORNERS
bool bound_may_hit_corners(Slab node, Interval interval, vec3 a, vec3 b, vec3 c, bool use_interval) {
  return slab_may_hit_corners_box(node, interval, a, b, c, use_interval);
}

#define READY ReadySlab
READY ready(Slab node, bool use_interval) { return slab_ready(node, use_interval); }
bool ready_may_hit_box(READY node, float reach, vec3 low, vec3 high, out float enter) {
  return slab_ready_may_hit_box(node, reach, low, high, enter);
}
bool ready_may_hit_corners(READY node, float reach, vec3 a, vec3 b, vec3 c, out float enter) {
  return slab_ready_may_hit_corners_box(node, reach, a, b, c, enter);
}
