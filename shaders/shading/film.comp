#version 460
// A sample's surfaces of k = 0 into the film, in image order: light and albedo are summed over samples; depth, normal,
// position and ids are those of the first sample, which lies at the pixel's centre. Lane: a surface.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/exact.glsl"
#include "lib/invocation.glsl"
#include "shared/limits.h"
#include "shared/scene.h"

layout(push_constant, scalar) uniform Push {
  vec3 eye;
  uint count;
  vec3 forward;
  uint first_sample;  // 1: also the geometry
  uint opaque;        // 1: the background covers
};
layout(binding = 0, scalar) readonly buffer Totals { vec4 totals[]; };
layout(binding = 1, scalar) readonly buffer Positions { vec4 positions[]; };
layout(binding = 2, scalar) readonly buffer Normals { vec4 normals[]; };
layout(binding = 3, scalar) readonly buffer Diffuses { vec4 diffuses[]; };
layout(binding = 4, scalar) readonly buffer Speculars { vec4 speculars[]; };
layout(binding = 5, scalar) readonly buffer Emissions { vec4 emissions[]; };
layout(binding = 6, scalar) readonly buffer CornersA { vec4 corner_a[]; };
layout(binding = 7, scalar) readonly buffer CornersB { vec4 corner_b[]; };
layout(binding = 8, scalar) buffer Beauty { vec4 beauty[]; };
layout(binding = 9, scalar) buffer Albedo { vec4 albedo[]; };
layout(binding = 10, scalar) writeonly buffer NormalDepth { vec4 normal_depth[]; };
layout(binding = 11, scalar) writeonly buffer Points { vec4 points[]; };
layout(binding = 12, scalar) writeonly buffer Ids { uvec2 ids[]; };  // object and material, from 1 on

const float nothing_depth = 1e10;

void store_geometry(uint surface, uint pixel, uint triangle) {
  if (triangle == none) {
    normal_depth[pixel] = vec4(vec3(0.0), nothing_depth);
    points[pixel] = vec4(0.0);
    ids[pixel] = uvec2(0u);
    return;
  }
  vec3 point = positions[surface].xyz;
  normal_depth[pixel] = vec4(normals[surface].xyz, exact_dot(point - eye, forward));
  points[pixel] = vec4(point, 1.0);
  ids[pixel] = uvec2(floatBitsToUint(corner_b[triangle].w),
                     floatBitsToUint(corner_a[triangle].w) & triangle_material_mask) + 1u;
}

void main() {
  uint i = invocation_index();
  if (i >= count) return;
  vec4 diffuse = diffuses[i], emission = emissions[i], total = totals[i];
  uint pixel = floatBitsToUint(diffuse.w);
  uint triangle = floatBitsToUint(positions[i].w);
  bool met = triangle != none;
  beauty[pixel] += vec4(total.rgb, opaque == 1u ? 1.0 : total.w);
  if (met) albedo[pixel] += vec4(diffuse.rgb + speculars[i].rgb - vec3(emission.w), 1.0);
  if (first_sample == 1u) store_geometry(i, pixel, triangle);
}
