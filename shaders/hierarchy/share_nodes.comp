#version 460
// Shares the tests of each node of a level and segment equally among its rays, and adds them to these rays' pixels
// (layers Tests.*). Lane: a ray, in sorted order, which looks up its node.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"

layout(push_constant, scalar) uniform Push {
  uint first_ray;  // sorted position of the segment's first
  uint rays;
  uint surfaces;       // slots a segment
  uint first_surface;  // of the batch
  uint first_node;     // of the segment
  uint nodes;
  uint first_account;  // of the level's node 0
};
layout(binding = 0, scalar) readonly buffer Slots { uint slots[]; };
layout(binding = 1, scalar) readonly buffer Pixels { vec4 pixels[]; };
layout(binding = 2, scalar) readonly buffer Order { uint order[]; };  // creation index a sorted position
layout(binding = 3, scalar) readonly buffer NodeRays { uvec2 rays_of[]; };
layout(binding = 4, scalar) readonly buffer Account { uint account[]; };
layout(binding = 5, scalar) buffer Tests { uvec2 tests[]; };
#include "hierarchy/share.glsl"

/// The node that holds this position: the segment's last one that does not begin after it.
uint node_of(uint position) {
  uint low = first_node, high = first_node + nodes;
  while (low + 1u < high) {
    uint middle = (low + high) / 2u;
    if (rays_of[middle].x <= position) low = middle;
    else high = middle;
  }
  return low;
}

void main() {
  uint i = invocation_index();
  if (i >= rays) return;
  uint position = first_ray + i;
  uint node = node_of(position);
  uvec2 range = rays_of[node];
  add_to_pixel(pixel_of(order[position], surfaces, first_surface),
               share_of(account[first_account + node], range.y - range.x, position - range.x));
}
