#version 460
// Writes the distance of the first sample's surfaces along the view axis. Lane: a surface.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/exact.glsl"
#include "lib/invocation.glsl"
#include "shared/limits.h"

layout(push_constant, scalar) uniform Push {
  vec3 eye;
  uint count;
  vec3 forward;
};
layout(binding = 0, scalar) readonly buffer Diffuses { vec4 diffuse_pixel[]; };
layout(binding = 1, scalar) readonly buffer Positions { vec4 positions[]; };
layout(binding = 2, scalar) writeonly buffer Depths { float depths[]; };

const float nothing_depth = 1e10;

void main() {
  uint i = invocation_index();
  if (i >= count) return;
  vec4 position = positions[i];
  bool met = floatBitsToUint(position.w) != none;
  depths[floatBitsToUint(diffuse_pixel[i].w)] = met ? exact_dot(position.xyz - eye, forward) : nothing_depth;
}
