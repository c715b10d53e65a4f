#version 460
// Copies the triangles into leaf order, each with its number. Lane: a place in the order.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"

layout(push_constant, scalar) uniform Push { uint count; };
layout(binding = 0, scalar) readonly buffer CornersA { vec4 corner_a[]; };
layout(binding = 1, scalar) readonly buffer CornersB { vec4 corner_b[]; };
layout(binding = 2, scalar) readonly buffer CornersC { vec4 corner_c[]; };
layout(binding = 3, scalar) readonly buffer Order { uint order[]; };
layout(binding = 4, scalar) writeonly buffer LeafA { vec4 leaf_a[]; };
layout(binding = 5, scalar) writeonly buffer LeafB { vec4 leaf_b[]; };
layout(binding = 6, scalar) writeonly buffer LeafC { vec4 leaf_c[]; };

void main() {
  uint i = invocation_index();
  if (i >= count) return;
  uint triangle = order[i];
  leaf_a[i] = corner_a[triangle];
  leaf_b[i] = corner_b[triangle];
  leaf_c[i] = vec4(corner_c[triangle].xyz, uintBitsToFloat(triangle));
}
