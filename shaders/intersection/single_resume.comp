#version 460
// Goes on with rays that need very many tests, a piece of them a dispatch. Between dispatches a ray's stack and what
// it visits next lie in memory. Lane: a ray of the list.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
layout(local_size_x = 64) in;
#include "intersection/walk.glsl"
#include "lib/counters.glsl"
#include "lib/invocation.glsl"

layout(push_constant, scalar) uniform Push {
  uint first_ray;  // of the segment
  uint first;      // of the list
  uint count;
  uint box_counter;
  uint triangle_counter;
  uint box_account;  // of ray 0
  uint triangle_account;
};
layout(binding = 9, scalar) readonly buffer List {
  uint list_count;
  uint list[];  // rays, counted from first_ray
};
layout(binding = 10, scalar) buffer Walking { uint walking[]; };  // one: rays that have not ended
layout(binding = 11, scalar) buffer States { uvec2 states[]; };   // a lane: Walk.next and .depth
layout(binding = 12, scalar) buffer Stacks { uvec2 stacks[]; };   // a lane: max_object_depth entries
#define ACCOUNT_BINDING 13
#include "lib/account.glsl"

void main() {
  uint i = invocation_index();
  if (i >= count) return;
  uint id = first_ray + list[first + i], base = i * max_object_depth;
  Ray ray = rays[id];
  Walk walk = Walk(states[i].x, states[i].y, hits[id], 0u, 0u);
  for (uint k = 0u; k < walk.depth; ++k) stack[k] = stacks[base + k];
  continue_walk(walk, ray, takes_any_hit(ray));
  hits[id] = walk.hit;
  states[i] = uvec2(walk.next, walk.depth);
  for (uint k = 0u; k < walk.depth; ++k) stacks[base + k] = stack[k];
  if (walk.next != none) atomicAdd(walking[0], 1u);
  ADD_COUNTER(box_counter, walk.box_tests)
  ADD_COUNTER(triangle_counter, walk.triangle_tests)
  ACCOUNT(tests_object, box_account + id, walk.box_tests)
  ACCOUNT(tests_triangle, triangle_account + id, walk.triangle_tests)
}
