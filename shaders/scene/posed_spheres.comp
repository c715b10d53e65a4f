#version 460
// Spheres around instances that deform (section 3.2.1): around the middle of their boxes, outside of all their
// triangles' spheres. The radius is that of the farthest one, whoever comes first. Lane: a block of an instance's
// triangles.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"
#include "lib/triangle.glsl"
#include "scene/posed_box.glsl"
#include "shared/scene.h"

layout(push_constant, scalar) uniform Push { uint count; };
layout(binding = 0, scalar) readonly buffer Blocks { uvec4 blocks[]; };  // posed instance, first triangle, count
layout(binding = 1, scalar) readonly buffer PosedInstances { PosedInstance posed_instances[]; };
layout(binding = 2, scalar) readonly buffer Spheres { vec4 triangle_spheres[]; };
layout(binding = 3, scalar) readonly buffer Boxes { uint boxes[]; };
layout(binding = 4, scalar) buffer ObjectSpheres { uint object_spheres[]; };  // bits of a vec4 each; radius 0 at first

void main() {
  uint i = invocation_index();
  if (i >= count) return;
  uvec4 block = blocks[i];
  vec3 centre;
  for (uint axis = 0u; axis < 3u; ++axis) {
    precise float low = unordered(boxes[6u * block.x + axis]), high = unordered(boxes[6u * block.x + 3u + axis]);
    precise float middle = low * 0.5 + high * 0.5;
    centre[axis] = middle;
  }
  float radius = 0.0;
  for (uint t = block.y; t < block.y + block.z; ++t) {
    vec4 sphere = triangle_spheres[t];
    precise float reach = (exact_length(sphere.xyz - centre) + sphere.w) * bound_slack;
    radius = max(radius, reach);
  }
  uint sphere = 4u * posed_instances[block.x].instance;
  for (uint axis = 0u; axis < 3u; ++axis) object_spheres[sphere + axis] = floatBitsToUint(centre[axis]);
  atomicMax(object_spheres[sphere + 3u], floatBitsToUint(radius));
}
