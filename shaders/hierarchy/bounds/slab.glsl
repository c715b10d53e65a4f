// Node bound "slab": for each axis the ranges of its rays' origins, ends and directions. A test against a box is a
// single ray's slab test in interval arithmetic; one against a triangle tests the triangle's box. An axis with a range
// of directions that includes zero rejects little. Cut nodes (--nodes cut) have no such axis, as their directions share
// an octant.

#include "hierarchy/slab.glsl"

#define BOUND_TESTS_CORNERS
bool bound_may_hit_corners(Slab node, Interval interval, vec3 a, vec3 b, vec3 c, bool use_interval) {
  return slab_may_hit_corners_box(node, interval, a, b, c, use_interval);
}

#define PREPARED PreparedSlab
PREPARED prepare(Slab node, bool use_interval) { return slab_prepare(node, use_interval); }
bool prepared_may_hit_box(PREPARED node, float reach, vec3 low, vec3 high, out float enter) {
  return slab_prepared_may_hit_box(node, reach, low, high, enter);
}
bool prepared_may_hit_corners(PREPARED node, float reach, vec3 a, vec3 b, vec3 c, out float enter) {
  return slab_prepared_may_hit_corners_box(node, reach, a, b, c, enter);
}
