#version 460
// Final intersection (section 3.2.6): a lane takes one ray and walks the triangles that its level-1 node may hit.
// The rays of one node are neighbouring lanes and read the same triangles.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
layout(local_size_x = 64) in;
#include "intersection/meet.glsl"
#include "lib/counters.glsl"
#include "lib/invocation.glsl"
#include "shared/node.h"

layout(push_constant, scalar) uniform Push {
  uint first_ray;     // sorted position
  uint ray_count;
  uint first_node;
  uint first_base;    // element of `bases` that belongs to first_node
  uint pairs_before;  // value of that element
  uint tests_counter;
};
layout(binding = 5, scalar) readonly buffer Rays { Ray rays[]; };       // in sorted order
layout(binding = 6, scalar) readonly buffer Order { uint order[]; };    // creation index a sorted position
layout(binding = 7, scalar) readonly buffer Parents { uint parents[]; };
layout(binding = 8, scalar) readonly buffer Bases { uint bases[]; };
layout(binding = 9, scalar) readonly buffer Pairs { HitPair pairs[]; };
layout(binding = 10, scalar) buffer Counters { uvec2 counters[]; };

void main() {
  uint i = invocation_index();
  if (i >= ray_count) return;
  uint position = first_ray + i;
  uint base = first_base + parents[position] - first_node;
  uint begin = bases[base] - pairs_before, end = bases[base + 1u] - pairs_before;
  Ray ray = rays[position];
  uint id = order[position];
  uvec4 hit = hits[id];
  for (uint pair = begin; pair < end; ++pair) hit = meet(hit, ray, pairs[pair].triangle);
  hits[id] = hit;
  ADD_COUNTER(tests_counter, end - begin)
}
