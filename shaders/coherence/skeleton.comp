#version 460
// Ray decompression (section 3.2.3, Figure 6), first step: the skeleton array, which holds the size of every chunk in
// sorted order. Bases are put into the same order, so that the last step reads both one after another.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/invocation.glsl"

layout(local_size_x = 64) in;
layout(scalar, binding = 0) readonly buffer Sorted { uint sorted[]; };  // chunks in the order of their keys
layout(scalar, binding = 1) readonly buffer Bases { uint bases[]; };    // by chunk
layout(scalar, binding = 2) readonly buffer Sizes { uint sizes[]; };    // by chunk
layout(scalar, binding = 3) writeonly buffer Skeleton { uint skeleton[]; };
layout(scalar, binding = 4) writeonly buffer SortedBases { uint sorted_bases[]; };
layout(scalar, push_constant) uniform Push { uint chunk_count; };

void main() {
  const uint i = invocation_index();
  if (i >= chunk_count) return;
  const uint chunk = sorted[i];
  skeleton[i] = sizes[chunk];
  sorted_bases[i] = bases[chunk];
}
