#version 460
// Finds, from the root down, which places in leaf order each raw node's triangles have, and which raw nodes are kept:
// those that are not leaves, and below no leaf. Lane: a raw node of one round.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"
#include "objects/raw.glsl"

layout(push_constant, scalar) uniform Push { uint first, count; };
layout(binding = 0, scalar) readonly buffer RawNodes { uvec4 raw_nodes[]; };
layout(binding = 1, scalar) buffer Firsts { uint firsts[]; };  // a raw node: the first of its triangles
layout(binding = 2, scalar) buffer Kept { uint kept[]; };      // a raw node: 1 where it is kept
layout(binding = 3, scalar) writeonly buffer Order { uint order[]; };

void main() {
  uint i = invocation_index();
  if (i >= count) return;
  uint raw = first + i;
  RawNode node = raw_node_of(raw_nodes[raw]);
  uint begin = firsts[raw];
  for (uint c = 0u; c < 2u; ++c) {
    uint child = node.child[c];
    if ((child & child_is_leaf) != 0u) {
      order[begin] = child & ~child_is_leaf;
    } else {
      firsts[child] = begin;
      kept[child] = raw_node_of(raw_nodes[child]).leaf ? 0u : kept[raw];
    }
    begin += node.count[c];
  }
}
