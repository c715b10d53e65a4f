// What all kernels that fill a level have in common: the bound, the bindings of the level and of the sorted rays, and
// the function that stores a node.

layout(local_size_x = 64) in;
#include "lib/invocation.glsl"
#include "shared/node.h"
#include "shared/ray.h"

/// Test-only mutation: cones are narrower by this factor, which tests must notice.
layout(constant_id = 0) const float cone_scale = 1.0;

layout(push_constant, scalar) uniform Push { uint node_count; };
layout(binding = 0, scalar) readonly buffer Rays { Ray rays[]; };
layout(binding = 1, scalar) readonly buffer Ranges { uvec2 ranges[]; };  // of a node's children (merge) or rays (fit)
#define CRSH_SORTED_RAYS
Ray sorted_ray(uint i) { return rays[i]; }
#include "variant.glsl"

layout(binding = 2, scalar) writeonly buffer Nodes { BOUND nodes[]; };
layout(binding = 3, scalar) writeonly buffer Intervals { Interval intervals[]; };

void store(uint i, BOUND node, float far_end) {
  nodes[i] = cone_scale == 1.0 ? node : bound_narrowed(node, cone_scale);
  intervals[i] = Interval(0.0, far_end);
}
