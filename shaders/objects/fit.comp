#version 460
// The boxes of a node's children, and the cost that the surface area heuristic expects of the node. Dispatches go from
// the leaves up: none of a dispatch's nodes is an ancestor of another, and all nodes below them are done. Lane: a node.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/box.glsl"
#include "lib/invocation.glsl"
#include "shared/object.h"

layout(push_constant, scalar) uniform Push { uint first, count; };
layout(binding = 0, scalar) readonly buffer LeafA { vec4 leaf_a[]; };
layout(binding = 1, scalar) readonly buffer LeafB { vec4 leaf_b[]; };
layout(binding = 2, scalar) readonly buffer LeafC { vec4 leaf_c[]; };
layout(binding = 3, scalar) buffer Low { vec4 box_low[]; };
layout(binding = 4, scalar) buffer High { vec4 box_high[]; };
layout(binding = 5, scalar) buffer Costs { float costs[]; };  // a node: expected tests, times its area
layout(binding = 6, scalar) writeonly buffer Root { vec4 root[]; };

Box box_of_leaf(uint begin, uint end) {
  Box box = empty_box();
  for (uint i = begin; i < end; ++i) box = merged(box, box_of(leaf_a[i].xyz, leaf_b[i].xyz, leaf_c[i].xyz));
  return box;
}

Box box_of_node(uint node) {
  return Box(min(box_low[2u * node].xyz, box_low[2u * node + 1u].xyz),
             max(box_high[2u * node].xyz, box_high[2u * node + 1u].xyz));
}

void main() {
  uint i = invocation_index();
  if (i >= count) return;
  uint node = first + i;
  Box whole = empty_box();
  precise float below = 0.0;
  for (uint slot = 2u * node; slot < 2u * node + 2u; ++slot) {
    uint ref = floatBitsToUint(box_low[slot].w), triangles = floatBitsToUint(box_high[slot].w);
    bool leaf = (ref & child_is_leaf) != 0u;
    uint begin = ref & ~child_is_leaf;
    Box box = leaf ? box_of_leaf(begin, begin + triangles) : box_of_node(ref);
    box_low[slot].xyz = box.low;
    box_high[slot].xyz = box.high;
    below += leaf ? triangle_cost * float(triangles) * half_area(box) : costs[ref];
    whole = merged(whole, box);
  }
  precise float area = half_area(whole);
  precise float cost = 2.0 * box_cost * area + below;
  costs[node] = cost;
  // The root is done last: its box, cost and area.
  if (node == 0u) {
    root[0] = vec4(whole.low, cost);
    root[1] = vec4(whole.high, area);
  }
}
