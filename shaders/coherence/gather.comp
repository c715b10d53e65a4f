#version 460
// Copies the rays into sorted order (section 3.2.3: the sorted ray array), so that later stages read them one after
// another.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/invocation.glsl"
#include "shared/ray.h"

layout(local_size_x = 64) in;
layout(scalar, binding = 0) readonly buffer Rays { Ray rays[]; };  // in creation order
layout(scalar, binding = 1) readonly buffer Order { uint order[]; };
layout(scalar, binding = 2) writeonly buffer Sorted { Ray sorted[]; };
layout(scalar, push_constant) uniform Push { uint count; };

void main() {
  const uint i = invocation_index();
  if (i < count) sorted[i] = rays[order[i]];
}
