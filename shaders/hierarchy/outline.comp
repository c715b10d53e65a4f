#version 460
// variants: hierarchy/bounds
// Balls around where the rays of a level's nodes start, and cones around where they go, for looking at them.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/invocation.glsl"
#include "shared/node.h"
#include "shared/ray.h"
#include "variant.glsl"

layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { uint node_count; };
layout(binding = 0, scalar) readonly buffer Nodes { BOUND nodes[]; };
layout(binding = 1, scalar) writeonly buffer Outlines { Node outlines[]; };

void main() {
  uint i = invocation_index();
  if (i < node_count) outlines[i] = bound_outline(nodes[i]);
}
