// A node prepared for many tests, as in a walk through the object hierarchy: what all tests need is computed once,
// because lavapipe moves nothing out of loops. A bound may bring READY and its three functions, as "slab" does; those
// for all others are here. A test's `enter`: none of the node's rays is in the box before that distance. `reach`:
// beyond that distance none needs to be tested. Both in metres.

#ifndef READY
struct ReadyBound {
  BOUND node;
  bool use_interval;
};
#define READY ReadyBound

READY ready(BOUND node, bool use_interval) { return ReadyBound(node, use_interval); }

bool ready_may_hit_box(READY ready, float reach, vec3 low, vec3 high, out float enter) {
  return bound_may_hit_box(ready.node, Interval(0.0, reach), low, high, ready.use_interval, enter);
}

bool ready_may_hit_corners(READY ready, float reach, vec3 a, vec3 b, vec3 c, out float enter) {
  enter = 0.0;
#ifdef BOUND_TESTS_CORNERS
  return bound_may_hit_corners(ready.node, Interval(0.0, reach), a, b, c, ready.use_interval);
#else
  return bound_may_hit_sphere(ready.node, Interval(0.0, reach), smallest_sphere(a, b, c), ready.use_interval);
#endif
}
#endif
