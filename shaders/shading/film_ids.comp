#version 460
// Object and material of the first sample's surfaces, from 1 on; 0 where nothing was met. Lane: a surface.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"
#include "scene/tables.glsl"

layout(push_constant, scalar) uniform Push { uint count; };
layout(binding = 0, scalar) readonly buffer Diffuses { vec4 diffuse_pixel[]; };
layout(binding = 1, scalar) readonly buffer Positions { vec4 positions[]; };
layout(binding = 2, scalar) writeonly buffer Ids { uvec2 ids[]; };

void main() {
  uint i = invocation_index();
  if (i >= count) return;
  uint triangle = floatBitsToUint(positions[i].w);
  uvec2 found = uvec2(0u);
  if (triangle != none) found = uvec2(instance_of(triangle), flags_of(triangle) & triangle_material_mask) + 1u;
  ids[floatBitsToUint(diffuse_pixel[i].w)] = found;
}
