#version 460
// Makes pairs (node, triangle) of the set bits of the top level's masks, node by node (section 3.2.5: trimming).
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"
#include "shared/node.h"
#include "traversal/emit.glsl"

layout(push_constant, scalar) uniform Push {
  uint first_node;   // of the piece, in its level
  uint node_offset;  // first node to emit, in the piece
  uint node_count;
  uint first_block;
  uint block_count;
  uint pairs_before;  // pairs of the piece that lie before the first to emit
};
layout(binding = 0, scalar) readonly buffer Blocks { uvec4 blocks[]; };
layout(binding = 1, scalar) readonly buffer Masks { uint masks[]; };
layout(binding = 2, scalar) readonly buffer Scanned { uint scanned[]; };
layout(binding = 3, scalar) writeonly buffer Pairs { HitPair pairs[]; };

void main() {
  uint i = invocation_index();
  if (i >= node_count * block_count) return;
  uint node = node_offset + i / block_count, block_index = i % block_count;
  uint mask = masks[node * block_count + block_index];
  uint place = scanned[node * block_count + block_index] - pairs_before;
  uint first = blocks[first_block + block_index].y;
  while (mask != 0u) {
    uint k = uint(findLSB(mask));
    pairs[place] = emitted(place, first_node + node, first + k);
    ++place;
    mask &= mask - 1u;
  }
}
