#version 460
// Adds a value of each surface of a sample to its pixel: light or a part of it, F0, and for the first sample also
// position and normal. The value is 0 where nothing was met. Lane: a surface.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"

layout(push_constant, scalar) uniform Push { uint count; };
layout(binding = 0, scalar) readonly buffer Diffuses { vec4 diffuse_pixel[]; };
layout(binding = 1, scalar) readonly buffer Values { vec4 values[]; };
layout(binding = 2, scalar) buffer Sums { vec4 sums[]; };

void main() {
  uint i = invocation_index();
  if (i < count) sums[floatBitsToUint(diffuse_pixel[i].w)] += values[i];
}
