#version 460
// Final intersection (section 3.2.6): a lane takes one ray and walks the triangles that its level-1 node may hit.
// The rays of one node are neighbouring lanes and read the same triangles.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#include "lib/shuffle_read.glsl"
layout(local_size_x = 64) in;
#include "intersection/meet.glsl"
#include "lib/counters.glsl"
#include "lib/invocation.glsl"
#include "shared/node.h"

layout(push_constant, scalar) uniform Push {
  uint first_node;
  uint node_count;
  uint max_rays;      // of a node: each node has so many lanes
  uint first_base;    // element of `bases` that belongs to first_node
  uint pairs_before;  // value of that element
  uint tests_counter;
  uint first_account;  // of ray 0
};
layout(binding = 5, scalar) readonly buffer Rays { Ray rays[]; };     // in sorted order
layout(binding = 6, scalar) readonly buffer Order { uint order[]; };  // creation index a sorted position
layout(binding = 7, scalar) readonly buffer Children { uvec2 rays_of[]; };
layout(binding = 8, scalar) readonly buffer Bases { uint bases[]; };
layout(binding = 9, scalar) readonly buffer Pairs { HitPair pairs[]; };
layout(binding = 10, scalar) buffer Counters { uvec2 counters[]; };
#define ACCOUNT_BINDING 11
#include "lib/account.glsl"

void main() {
  uint i = invocation_index();
  uint place = min(i / max_rays, node_count - 1u);
  uvec2 node_rays = rays_of[first_node + place];
  uint position = node_rays.x + i % max_rays;
  bool present = i / max_rays < node_count && position < node_rays.y;
  position = min(position, node_rays.y - 1u);
  uint begin = bases[first_base + place] - pairs_before, end = bases[first_base + place + 1u] - pairs_before;
  Ray ray = rays[position];
  Shear shear = shear_of(ray.direction.xyz);
  uint id = order[position];
  uvec4 hit = hits[id];

  bool common_list = same_list(begin, end);
  uint own_end = common_list || !present ? begin : end;
  uint pair = begin;
  if (pair < own_end) {
    for (;;) {
      hit = meet(hit, ray, shear, load_triangle(pairs[pair].triangle));
      if (++pair >= own_end) break;
    }
  }
  if (common_list && begin < end) {
    for (;;) {
      Loaded mine = load_triangle(pairs[min(pair + gl_SubgroupInvocationID, end - 1u)].triangle);
      uint loaded = min(gl_SubgroupSize, end - pair), k = 0u;
      for (;;) {
        hit = meet(hit, ray, shear, passed_round(mine, k));
        if (++k >= loaded) break;
      }
      pair += gl_SubgroupSize;
      if (pair >= end) break;
    }
  }

  if (present) hits[id] = hit;
  uint tests = present ? end - begin : 0u;
  ADD_COUNTER(tests_counter, tests)
  ACCOUNT(tests_triangle, first_account + id, tests)
}
