#version 460
// Writes the nodes that are kept, in the raw tree's order: what each child is. Boxes are filled in later (fit.comp).
// Lane: a raw node.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"
#include "objects/raw.glsl"

layout(push_constant, scalar) uniform Push { uint count; };
layout(binding = 0, scalar) readonly buffer RawNodes { uvec4 raw_nodes[]; };
layout(binding = 1, scalar) readonly buffer Firsts { uint firsts[]; };
// Kept nodes before each; one element more than raw nodes.
layout(binding = 2, scalar) readonly buffer Places { uint places[]; };
layout(binding = 3, scalar) writeonly buffer Low { vec4 box_low[]; };
layout(binding = 4, scalar) writeonly buffer High { vec4 box_high[]; };

bool is_kept(uint raw) { return places[raw + 1u] != places[raw]; }

void main() {
  uint raw = invocation_index();
  if (raw >= count) return;
  if (!is_kept(raw)) return;
  RawNode node = raw_node_of(raw_nodes[raw]);
  uint begin = firsts[raw];
  for (uint c = 0u; c < 2u; ++c) {
    uint child = node.child[c];
    bool inner = (child & child_is_leaf) == 0u && is_kept(child & ~child_is_leaf);
    uint ref = inner ? places[child] : child_is_leaf | begin;
    uint slot = 2u * places[raw] + c;
    box_low[slot] = vec4(0.0, 0.0, 0.0, uintBitsToFloat(ref));
    box_high[slot] = vec4(0.0, 0.0, 0.0, uintBitsToFloat(node.count[c]));
    begin += node.count[c];
  }
}
