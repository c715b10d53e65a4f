#version 460
// Writes the three corners of each triangle one after the other, as the device's own hierarchy is built from. Lane: a
// triangle.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"

layout(push_constant, scalar) uniform Push { uint count; };
layout(binding = 0, scalar) readonly buffer CornersA { vec4 corner_a[]; };
layout(binding = 1, scalar) readonly buffer CornersB { vec4 corner_b[]; };
layout(binding = 2, scalar) readonly buffer CornersC { vec4 corner_c[]; };
layout(binding = 3, scalar) writeonly buffer Corners { vec4 corners[]; };

void main() {
  uint i = invocation_index();
  if (i >= count) return;
  corners[3u * i] = corner_a[i];
  corners[3u * i + 1u] = corner_b[i];
  corners[3u * i + 2u] = corner_c[i];
}
