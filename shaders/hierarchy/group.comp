#version 460
// Makes a node of every `arity` children of a segment: writes each child's parent, and where each node's children and
// rays begin and end (section 3.2.4). Nodes never cross the ends of a segment.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"

layout(push_constant, scalar) uniform Push {
  uint first_child;  // of the segment
  uint children;
  uint first_node;  // of the segment
  uint arity;
  uint rays_below;  // 1: children are rays themselves (level 1)
};
layout(binding = 0, scalar) readonly buffer RaysBelow { uvec2 rays_of_child[]; };
layout(binding = 1, scalar) writeonly buffer Parents { uint parents[]; };
layout(binding = 2, scalar) writeonly buffer Children { uvec2 children_of[]; };
layout(binding = 3, scalar) writeonly buffer NodeRays { uvec2 rays_of[]; };

void main() {
  uint i = invocation_index();
  if (i >= children) return;
  uint child = first_child + i;
  uint node = first_node + i / arity;
  parents[child] = node;
  if (i % arity != 0u) return;
  uint end = first_child + min(i + arity, children);
  children_of[node] = uvec2(child, end);
  rays_of[node] = rays_below == 1u ? uvec2(child, end) : uvec2(rays_of_child[child].x, rays_of_child[end - 1u].y);
}
