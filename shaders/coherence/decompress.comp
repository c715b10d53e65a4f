#version 460
// Ray decompression (section 3.2.3, Figure 6), last step: writes the rays of each chunk from the chunk's start on. A
// lane fills a fixed number of places, from as many chunks as these span, so that one huge chunk makes no long loop.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/invocation.glsl"
#include "coherence/rising.glsl"  // the starts of the sorted chunks: the skeleton after its exclusive scan, and the end

layout(local_size_x_id = 0) in;
layout(constant_id = 1) const uint run = 64;  // places a lane
layout(scalar, binding = 1) readonly buffer SortedBases { uint sorted_bases[]; };
layout(scalar, binding = 2) writeonly buffer Order { uint order[]; };
layout(scalar, push_constant) uniform Push { uint ray_count, chunk_count; };

void main() {
  const uint first = invocation_index() * run, end = min(first + run, ray_count);
  if (first >= end) return;
  uint chunk = last_not_above(first, chunk_count);
  uint shift = sorted_bases[chunk] - rising[chunk];  // from place to ray, modulo 2^32
  uint next = rising[chunk + 1];
  for (uint i = first; i < end; ++i) {
    if (i == next) {
      ++chunk;
      shift = sorted_bases[chunk] - next;
      next = rising[chunk + 1];
    }
    order[i] = i + shift;
  }
}
