#version 460
// What the surfaces of k = 0 see along the rays of one any-hit kind, lights for example: what each ray of a batch lets
// through, as luminance, and the number of rays, added to the pixel. Lane: a surface.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"
#include "shared/ray.h"

layout(push_constant, scalar) uniform Push {
  uint surfaces;       // slots a segment
  uint first_surface;  // of the batch
  uint first_slot;     // of the kind's first segment
  uint segments;       // of the kind
};
layout(binding = 0, scalar) readonly buffer Diffuses { vec4 diffuse_pixel[]; };
layout(binding = 1, scalar) readonly buffer Ends { uint ends[]; };
layout(binding = 2, scalar) readonly buffer Hits { Hit hits[]; };
layout(binding = 3, scalar) buffer Sums { vec4 sums[]; };  // x: visibility, y: rays
#include "shading/shadow_hits.glsl"

/// Rec. 709, exactly 1 where nothing is in the way.
float luminance(vec3 light) { return light.g + 0.2126 * (light.r - light.g) + 0.0722 * (light.b - light.g); }

void main() {
  uint i = invocation_index();
  if (i >= surfaces) return;
  vec2 sum = vec2(0.0);
  for (uint s = 0u; s < segments; ++s) {
    uint ray = ray_of(first_slot + s * surfaces + i);
    if (ray != none) sum += vec2(luminance(let_through(hits[ray].words.xyz)), 1.0);
  }
  sums[floatBitsToUint(diffuse_pixel[first_surface + i].w)] += vec4(sum, 0.0, 0.0);
}
