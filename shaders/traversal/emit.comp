#version 460
// Makes pairs (child node, triangle) of the set bits of the children's masks, node by node (section 3.2.5: trimming).
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"
#include "shared/node.h"
#include "traversal/descend.glsl"
#include "traversal/emit.glsl"

layout(push_constant, scalar) uniform Push {
  Slice slice;
  uint first_scanned;   // element of `scanned` that belongs to first_child
  uint emitted_before;  // value of that element
};
layout(binding = 0, scalar) readonly buffer Parents { uint parents[]; };
layout(binding = 1, scalar) readonly buffer Children { uvec2 children_of[]; };
layout(binding = 2, scalar) readonly buffer Bases { uint bases[]; };
layout(binding = 3, scalar) readonly buffer PairsAbove { HitPair pairs_above[]; };
layout(binding = 4, scalar) readonly buffer Masks { uint masks[]; };
layout(binding = 5, scalar) readonly buffer Scanned { uint scanned[]; };  // from the first child of the descent on
layout(binding = 6, scalar) writeonly buffer Pairs { HitPair pairs[]; };

void main() {
  uint i = invocation_index();
  if (i >= slice.child_count) return;
  uint child = slice.first_child + i;
  uint parent = parents[child];
  uint place_of_parent = parent - slice.first_parent;
  uint base = slice.first_base + place_of_parent;
  List list = list_of(slice, bases[base] - slice.pairs_before, bases[base + 1u] - slice.pairs_before, place_of_parent,
                      child - children_of[parent].x);
  uint place = scanned[first_scanned + i] - emitted_before;
  uint word = list.first_mask;
  for (uint begin = list.begin; begin < list.end; begin += 32u) {
    uint mask = masks[word++];
    while (mask != 0u) {
      uint k = uint(findLSB(mask));
      pairs[place] = emitted(place, child, pairs_above[begin + k].triangle);
      ++place;
      mask &= mask - 1u;
    }
  }
}
