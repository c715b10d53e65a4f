#version 460
// Every ray against every triangle: a lane takes one ray and walks a batch of triangles.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
layout(local_size_x = 64) in;
#include "intersection/meet.glsl"
#include "lib/counters.glsl"
#include "lib/invocation.glsl"

layout(push_constant, scalar) uniform Push {
  uint first_ray;
  uint ray_count;
  uint first_triangle;
  uint triangle_count;
  uint tests_counter;
};
layout(binding = 5, scalar) readonly buffer Rays { Ray rays[]; };  // in creation order
layout(binding = 6, scalar) buffer Counters { uvec2 counters[]; };

void main() {
  uint i = invocation_index();
  if (i >= ray_count) return;
  uint id = first_ray + i;
  Ray ray = rays[id];
  uvec4 hit = hits[id];
  uint tests = 0u;
  for (; tests < triangle_count; ++tests) hit = meet(hit, ray, first_triangle + tests);
  hits[id] = hit;
  ADD_COUNTER(tests_counter, tests)
}
