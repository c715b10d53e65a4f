#version 460
// Tests every ray against every triangle: a lane takes one ray and walks as many triangles as its loop may (limits.h).
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#include "lib/shuffle_read.glsl"
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
  uint first_account;  // of ray 0
};
layout(binding = 5, scalar) readonly buffer Rays { Ray rays[]; };  // in creation order
layout(binding = 6, scalar) buffer Counters { uvec2 counters[]; };
#define ACCOUNT_BINDING 7
#include "lib/account.glsl"

void main() {
  uint i = invocation_index();
  bool present = i < ray_count;
  uint id = first_ray + min(i, ray_count - 1u);
  Ray ray = rays[id];
  Shear shear = shear_of(ray.direction.xyz);
  uvec4 hit = hits[id];
  uint tests = 0u;
  bool common_list = same_list(first_triangle, triangle_count);
  if (common_list) {
    for (;;) {
      Loaded mine = load_triangle(first_triangle + min(tests + gl_SubgroupInvocationID, triangle_count - 1u));
      uint loaded = min(gl_SubgroupSize, triangle_count - tests), k = 0u;
      for (;;) {
        hit = meet(hit, ray, shear, passed_round(mine, k));
        if (++k >= loaded) break;
      }
      tests += loaded;
      if (tests >= triangle_count) break;
    }
  } else {
    for (;;) {
      hit = meet(hit, ray, shear, load_triangle(first_triangle + tests));
      if (++tests >= triangle_count) break;
    }
  }
  if (present) hits[id] = hit;
  tests = present ? tests : 0u;
  ADD_COUNTER(tests_counter, tests)
  ACCOUNT(tests_triangle, first_account + id, tests)
}
