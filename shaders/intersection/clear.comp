#version 460
// No hit yet: t infinite and no triangle, or a transmittance of 1 (-log2 is 0).
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"
#include "shared/limits.h"
#include "shared/ray.h"

layout(push_constant, scalar) uniform Push { uint count; };
layout(binding = 0, scalar) readonly buffer Rays { Ray rays[]; };
layout(binding = 1, scalar) writeonly buffer Hits { uvec4 hits[]; };

void main() {
  uint i = invocation_index();
  if (i >= count) return;
  bool shadow = uint(rays[i].direction.w) == kind_shadow;
  hits[i] = shadow ? uvec4(0u) : uvec4(0x7F800000u, none, 0u, 0u);
}
