#version 460
// Object and material of the first sample's surfaces, from 1 on; 0 where nothing was met. Lane: a surface.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"
#include "shared/limits.h"
#include "shared/scene.h"

layout(push_constant, scalar) uniform Push { uint count; };
layout(binding = 0, scalar) readonly buffer Diffuses { vec4 diffuse_pixel[]; };
layout(binding = 1, scalar) readonly buffer Positions { vec4 positions[]; };
layout(binding = 2, scalar) readonly buffer CornersA { vec4 corner_a[]; };
layout(binding = 3, scalar) readonly buffer CornersB { vec4 corner_b[]; };
layout(binding = 4, scalar) writeonly buffer Ids { uvec2 ids[]; };

void main() {
  uint i = invocation_index();
  if (i >= count) return;
  uint triangle = floatBitsToUint(positions[i].w);
  uvec2 found = uvec2(0u);
  if (triangle != none)
    found =
        uvec2(floatBitsToUint(corner_b[triangle].w), floatBitsToUint(corner_a[triangle].w) & triangle_material_mask) +
        1u;
  ids[floatBitsToUint(diffuse_pixel[i].w)] = found;
}
