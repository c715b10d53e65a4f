#version 460
// variants: hierarchy/bounds
// For the statistics, how wide the nodes of a level are: tangent of the half-angle, and radius.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/invocation.glsl"
#include "shared/node.h"
#include "shared/ray.h"
#include "variant.glsl"

layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { uint node_count; };
layout(binding = 0, scalar) readonly buffer Nodes { BOUND nodes[]; };
layout(binding = 1, scalar) writeonly buffer Spreads { vec2 spreads[]; };

void main() {
  uint i = invocation_index();
  if (i < node_count) spreads[i] = bound_spread(nodes[i]);
}
