#version 460
// Rays one by one through the object hierarchy. Those that need very many tests are left as they were, and listed: they
// are walked in pieces (single_resume.comp). Lane: a ray.
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
  uint first;      // ray of this dispatch, counted from first_ray
  uint end;
  uint box_counter;
  uint triangle_counter;
  uint box_account;  // of ray 0
  uint triangle_account;
  uint listed;  // 1: rays are those of the list
};
layout(binding = 9, scalar) buffer Unfinished {
  uint unfinished_count;
  uint unfinished[];  // rays, as in the list
};
layout(binding = 10, scalar) readonly buffer List {
  uint list_count;
  uint list[];  // rays, counted from first_ray
};
#define ACCOUNT_BINDING 11
#include "lib/account.glsl"

void main() {
  uint i = first + invocation_index();
  if (i >= end) return;
  uint place = i;
  if (listed == 1u) place = list[i];
  uint id = first_ray + place;
  Ray ray = rays[id];
  Walk walk = Walk(0u, 0u, no_hit(ray), 0u, 0u);
  continue_walk(walk, ray, takes_any_hit(ray));
  bool done = walk.next == none;
  if (!done) unfinished[atomicAdd(unfinished_count, 1u)] = place;
  hits[id] = done ? walk.hit : no_hit(ray);
  uint box_tests = done ? walk.box_tests : 0u, triangle_tests = done ? walk.triangle_tests : 0u;
  ADD_COUNTER(box_counter, box_tests)
  ADD_COUNTER(triangle_counter, triangle_tests)
  ACCOUNT(tests_object, box_account + id, box_tests)
  ACCOUNT(tests_triangle, triangle_account + id, triangle_tests)
}
