#version 460
// The order of rays that are not sorted: as they were created.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/invocation.glsl"

layout(local_size_x = 64) in;
layout(scalar, binding = 0) writeonly buffer Order { uvec4 order[]; };
layout(scalar, push_constant) uniform Push { uint quads; };

void main() {
  const uint quad = invocation_index();
  if (quad < quads) order[quad] = 4 * quad + uvec4(0, 1, 2, 3);
}
