#version 460
// Two clusters that are each other's nearest become one. Flags the clusters that remain: all but the second of each
// such pair. Lane: a cluster.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"

layout(push_constant, scalar) uniform Push { uint count; };
layout(binding = 0, scalar) readonly buffer Nearest { uint nearest[]; };
layout(binding = 1, scalar) writeonly buffer Stays { uint stays[]; };

void main() {
  uint i = invocation_index();
  if (i >= count) return;
  uint other = nearest[i];
  stays[i] = other < i && nearest[other] == i ? 0u : 1u;
}
