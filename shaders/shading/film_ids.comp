#version 460
// Number of the object or of the material of the first sample's surfaces, from 1 on; 0 where nothing was met. Lane: a
// surface.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"
#include "scene/tables.glsl"

layout(push_constant, scalar) uniform Push {
  uint count;
  uint material;  // 1: the material, 0: the object
};
layout(binding = 0, scalar) readonly buffer Diffuses { vec4 diffuse_pixel[]; };
layout(binding = 1, scalar) readonly buffer Positions { vec4 positions[]; };
layout(binding = 2, scalar) writeonly buffer Ids { uint ids[]; };

void main() {
  uint i = invocation_index();
  if (i >= count) return;
  uint triangle = floatBitsToUint(positions[i].w), found = 0u;
  if (triangle != none && material == 1u) found = (flags_of(triangle) & triangle_material_mask) + 1u;
  if (triangle != none && material == 0u) found = instance_of(triangle) + 1u;
  ids[floatBitsToUint(diffuse_pixel[i].w)] = found;
}
