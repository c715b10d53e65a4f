#version 460
// Sums up a 64-bit hash of each ray's hit, pixel, path and light over a segment: two digests are equal where all hits
// are, in whatever order the rays come. It also counts the rays that hit, and how often alpha was asked for. A lane
// takes several rays, so that subgroups add to memory less often.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
layout(local_size_x = 64) in;
#include "lib/chance.glsl"
#include "lib/counters.glsl"
#include "lib/invocation.glsl"
#include "shared/limits.h"
#include "shared/ray.h"

layout(push_constant, scalar) uniform Push {
  uint first_ray;  // of the segment
  uint ray_count;
  uint lanes;          // each takes every so many-th ray
  uint surfaces;       // slots a segment
  uint first_surface;  // of the batch
  uint kind;
  uint light;
  uint hits_counter;
  uint digest_counter;
  uint alpha_counter;
};
layout(binding = 0, scalar) readonly buffer Slots { uint slots[]; };
layout(binding = 1, scalar) readonly buffer Hits { uvec4 hits[]; };
layout(binding = 2, scalar) readonly buffer Pixels { vec4 diffuse_pixel[]; };
layout(binding = 3, scalar) readonly buffer Paths { vec4 specular_path[]; };
layout(binding = 4, scalar) buffer Counters { uvec2 counters[]; };

uvec2 digest_of(uint surface, uvec4 hit) {
  uint words[7] = uint[7](floatBitsToUint(diffuse_pixel[surface].w), floatBitsToUint(specular_path[surface].w), kind,
                          light, hit.x, hit.y, hit.z);
  uvec2 digest = uvec2(1u, 2u);
  for (uint k = 0u; k < 7u; ++k) digest = uvec2(absorbed(digest.x, words[k]), absorbed(digest.y, ~words[k]));
  return digest;
}

void main() {
  uint i = invocation_index();
  uint met = 0u, alphas = 0u;
  uvec4 parts = uvec4(0u);  // of 64-bit sums, modulo 2^64: 16 bits at a time so that a subgroup's sum fits a word
  if (i < lanes) {
    for (;;) {
      uint ray = first_ray + i;
      uvec4 hit = hits[ray];
      uvec2 digest = digest_of(first_surface + slots[ray] % surfaces, hit);
      parts += uvec4(digest.x & 0xFFFFu, digest.x >> 16, digest.y & 0xFFFFu, digest.y >> 16);
      bool any_hit = takes_any_hit(kind);
      met += (any_hit ? all(equal(hit.xyz, uvec3(0xFFFFFFFFu))) : hit.y != none) ? 1u : 0u;
      alphas += hit.w;
      i += lanes;
      if (i >= ray_count) break;
    }
  }
  ADD_COUNTER(hits_counter, met)
  ADD_COUNTER(alpha_counter, alphas)
  bool adds = true;
  if (lanes_reconverge) {
    parts = subgroupAdd(parts);
    adds = subgroupElect();
  }
  if (adds) {
    uint low = parts.x + (parts.y << 16);
    uint carry = (parts.y + (parts.x >> 16)) >> 16;
    uint high = parts.z + (parts.w << 16) + carry;
    uint before = atomicAdd(counters[digest_counter].x, low);
    atomicAdd(counters[digest_counter].y, high + (before + low < before ? 1u : 0u));
  }
}
