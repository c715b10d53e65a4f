#version 460
// As group.comp, for cut nodes: makes a node of the children from one head to the next (section 3.2.4).
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"

layout(push_constant, scalar) uniform Push {
  uint nodes;
  uint rays_below;  // 1: children are rays themselves (level 1)
};
layout(binding = 0, scalar) readonly buffer RaysBelow { uvec2 rays_of_child[]; };
layout(binding = 1, scalar) readonly buffer Bases { uint bases[]; };  // first child a node
layout(binding = 2, scalar) readonly buffer Ends { uint ends[]; };    // by first child
layout(binding = 3, scalar) writeonly buffer Parents { uint parents[]; };
layout(binding = 4, scalar) writeonly buffer Children { uvec2 children_of[]; };
layout(binding = 5, scalar) writeonly buffer NodeRays { uvec2 rays_of[]; };

void main() {
  uint node = invocation_index();
  if (node >= nodes) return;
  uint base = bases[node], end = ends[base];
  children_of[node] = uvec2(base, end);
  rays_of[node] = rays_below == 1u ? uvec2(base, end) : uvec2(rays_of_child[base].x, rays_of_child[end - 1u].y);
  uint child = base;
  for (;;) {
    parents[child] = node;
    if (++child >= end) break;
  }
}
