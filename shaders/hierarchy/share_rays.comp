#version 460
// Adds the tests of rays themselves to their pixels (layers Tests.*). Lane: a ray, in creation order.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"

layout(push_constant, scalar) uniform Push {
  uint rays;
  uint surfaces;       // slots a segment
  uint first_surface;  // of the batch
  uint first_account;  // of ray 0
};
layout(binding = 0, scalar) readonly buffer Slots { uint slots[]; };
layout(binding = 1, scalar) readonly buffer Pixels { vec4 pixels[]; };
layout(binding = 2, scalar) readonly buffer Account { uint account[]; };
layout(binding = 3, scalar) buffer Tests { uvec2 tests[]; };
#include "hierarchy/share.glsl"

void main() {
  uint i = invocation_index();
  if (i >= rays) return;
  add_to_pixel(pixel_of(i, surfaces, first_surface), fixed_point(account[first_account + i]));
}
