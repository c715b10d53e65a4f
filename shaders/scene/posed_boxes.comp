#version 460
// Boxes around instances that deform, from the spheres of their triangles (section 3.2.1): first step of
// posed_spheres.comp. Lane: a block of an instance's triangles.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"
#include "scene/posed_box.glsl"

layout(push_constant, scalar) uniform Push { uint count; };
layout(binding = 0, scalar) readonly buffer Blocks { uvec4 blocks[]; };  // posed instance, first triangle, count
layout(binding = 1, scalar) readonly buffer Spheres { vec4 triangle_spheres[]; };
layout(binding = 2, scalar) buffer Boxes { uint boxes[]; };

void main() {
  uint i = invocation_index();
  if (i >= count) return;
  uvec4 block = blocks[i];
  vec4 first = triangle_spheres[block.y];
  vec3 low = first.xyz - first.w, high = first.xyz + first.w;
  for (uint t = block.y + 1u; t < block.y + block.z; ++t) {
    vec4 sphere = triangle_spheres[t];
    low = min(low, sphere.xyz - sphere.w);
    high = max(high, sphere.xyz + sphere.w);
  }
  for (uint axis = 0u; axis < 3u; ++axis) {
    atomicMin(boxes[6u * block.x + axis], ordered(low[axis]));
    atomicMax(boxes[6u * block.x + 3u + axis], ordered(high[axis]));
  }
}
