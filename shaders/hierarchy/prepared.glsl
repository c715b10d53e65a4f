// A node prepared for many tests, as in a walk through the object hierarchy: what all tests need is computed once,
// because lavapipe moves nothing out of loops. A bound may bring PREPARED and its three functions, as "slab" does;
// those for all others are here. A test's `enter`: none of the node's rays is in the box before that distance. `reach`:
// beyond that distance none needs to be tested. Both in metres.

#ifndef PREPARED
struct PreparedBound {
  BOUND node;
  bool use_interval;
};
#define PREPARED PreparedBound

PREPARED prepare(BOUND node, bool use_interval) { return PreparedBound(node, use_interval); }

bool prepared_may_hit_box(PREPARED prepared, float reach, vec3 low, vec3 high, out float enter) {
  return bound_may_hit_box(prepared.node, Interval(0.0, reach), low, high, prepared.use_interval, enter);
}

bool prepared_may_hit_corners(PREPARED prepared, float reach, vec3 a, vec3 b, vec3 c, out float enter) {
  enter = 0.0;
#ifdef BOUND_TESTS_CORNERS
  return bound_may_hit_corners(prepared.node, Interval(0.0, reach), a, b, c, prepared.use_interval);
#else
  return bound_may_hit_sphere(prepared.node, Interval(0.0, reach), smallest_sphere(a, b, c), prepared.use_interval);
#endif
}
#endif
