#version 460
// variants: rays/keys
// Section 3.2.2, Figures 2 and 3: the hash of every ray of a segment, and its key-value pair. The segment, which grows
// with the kind and then the light, is the key's highest part.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/invocation.glsl"
#include "shared/ray.h"
#include "variant.glsl"

layout(local_size_x = 64) in;
layout(scalar, binding = 0) readonly buffer Rays { Ray rays[]; };
layout(scalar, binding = 1) writeonly buffer Pairs { uvec2 pairs[]; };  // key, ray
layout(scalar, push_constant) uniform Push {
  vec3 scene_low;             // metres
  uint first;                 // ray of the segment
  vec3 scene_inverse_extent;  // 1 / metres, 0 where the scene is flat
  uint count;                 // rays of the segment
  uint segment;               // its number, shifted above the hash
  uint shared_origin;         // 1: the segment's rays begin at one place
};

void main() {
  if (invocation_index() >= count) return;
  const uint ray = first + invocation_index();
  precise vec3 place = (rays[ray].origin.xyz - scene_low) * scene_inverse_extent;
  pairs[ray] = uvec2(segment | ray_key(place, rays[ray].direction.xyz, shared_origin == 1u), ray);
}
