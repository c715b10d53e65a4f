// Node bound "slab-edges": the ranges of "slab", and against a triangle also the sides of its edges on which the rays
// may pass. So it can tell the two triangles of a wall apart, which have the same box.
//
// A ray from o along d passes the edge from p to q on the side that the sign of f = d · ((p - o) × (q - o)) tells. It
// hits the triangle only where the f of all three edges have the sign of d · n, with n the triangle's normal; their sum
// is d · n. Each f is linear in o and in d. So over a node it lies in a range around its value for the middle of both.

#include "hierarchy/slab.glsl"

/// How far f may be off, as a share of |p - o| |q - o|: the float triangle test (lib/triangle.glsl) may accept rays
/// beyond an edge, and the arithmetic here rounds; each is below 2^-20.
const float edge_slack = 3.814697265625e-6;

/// The middle of the ranges of origins and directions, and half of their lengths.
struct Middle {
  vec3 origin;
  vec3 origin_reach;
  vec3 direction;
  vec3 direction_reach;
};

Middle middle_of(Slab node) {
  precise vec3 origin = 0.5 * (node.origin_low.xyz + node.origin_high.xyz);
  precise vec3 origin_reach = max(node.origin_high.xyz - origin, origin - node.origin_low.xyz) * bound_slack;
  precise vec3 direction = 0.5 * (node.direction_low.xyz + node.direction_high.xyz);
  precise vec3 direction_reach =
      max(node.direction_high.xyz - direction, direction - node.direction_low.xyz) * bound_slack;
  return Middle(origin, origin_reach, direction, direction_reach);
}

float size_of(vec3 v) { return abs(v.x) + abs(v.y) + abs(v.z); }

/// The least and the greatest f of the node's rays; p and q are relative to the middle of the origins.
vec2 side_of_edge(Middle node, vec3 p, vec3 q) {
  vec3 across = cross(p, q);
  float middle = dot(node.direction, across);
  vec3 edge = p - q;
  vec3 turning = abs(cross(edge, node.direction)) + abs(edge.yzx) * node.direction_reach.zxy +
                 abs(edge.zxy) * node.direction_reach.yzx;
  float reach = dot(node.direction_reach, abs(across)) + dot(node.origin_reach, turning);
  float from_any = size_of(node.origin_reach);
  float slack = edge_slack * (size_of(p) + from_any) * (size_of(q) + from_any) + bound_pad * reach;
  return vec2(middle - reach - slack, middle + reach + slack);
}

/// Whether the rays may pass all three edges on one side.
bool may_pass_between(Middle middle, vec3 a, vec3 b, vec3 c) {
  vec3 pa = a - middle.origin, pb = b - middle.origin, pc = c - middle.origin;
  vec2 ab = side_of_edge(middle, pa, pb), bc = side_of_edge(middle, pb, pc), ca = side_of_edge(middle, pc, pa);
  bool may_be_positive = min(min(ab.y, bc.y), ca.y) >= 0.0;  // all three
  bool may_be_negative = max(max(ab.x, bc.x), ca.x) <= 0.0;
  return may_be_positive || may_be_negative;
}

#define BOUND_TESTS_CORNERS
bool bound_may_hit_corners(Slab node, Interval interval, vec3 a, vec3 b, vec3 c, bool use_interval) {
  bool may_hit = slab_may_hit_corners_box(node, interval, a, b, c, use_interval);
  if (may_hit) may_hit = may_pass_between(middle_of(node), a, b, c);
  return may_hit;
}

struct PreparedEdges {
  PreparedSlab slab;
  Middle middle;
};
#define PREPARED PreparedEdges
PREPARED prepare(Slab node, bool use_interval) {
  return PreparedEdges(slab_prepare(node, use_interval), middle_of(node));
}
bool prepared_may_hit_box(PREPARED node, float reach, vec3 low, vec3 high, out float enter) {
  return slab_prepared_may_hit_box(node.slab, reach, low, high, enter);
}
bool prepared_may_hit_corners(PREPARED node, float reach, vec3 a, vec3 b, vec3 c, out float enter) {
  bool may_hit = slab_prepared_may_hit_corners_box(node.slab, reach, a, b, c, enter);
  if (may_hit) may_hit = may_pass_between(node.middle, a, b, c);
  return may_hit;
}
