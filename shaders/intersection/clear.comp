#version 460
// Sets all hits to "none yet", for kernels that add to them in several dispatches.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "intersection/no_hit.glsl"
#include "lib/invocation.glsl"

layout(push_constant, scalar) uniform Push { uint count; };
layout(binding = 0, scalar) readonly buffer Rays { Ray rays[]; };
layout(binding = 1, scalar) writeonly buffer Hits { uvec4 hits[]; };

void main() {
  uint i = invocation_index();
  if (i < count) hits[i] = no_hit(rays[i]);
}
