#version 460
// Ray compression (section 3.2.3, Figure 5), last step: key and size of each chunk, from the chunk bases.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/invocation.glsl"

layout(local_size_x = 64) in;
layout(scalar, binding = 0) readonly buffer Pairs { uvec2 pairs[]; };     // key, ray
layout(scalar, binding = 1) readonly buffer Bases { uint bases[]; };      // first ray of each chunk
layout(scalar, binding = 2) writeonly buffer Chunks { uvec2 chunks[]; };  // key, chunk
layout(scalar, binding = 3) writeonly buffer Sizes { uint sizes[]; };     // rays of each chunk
layout(scalar, push_constant) uniform Push { uint chunk_count, ray_count; };

void main() {
  const uint chunk = invocation_index();
  if (chunk >= chunk_count) return;
  const uint base = bases[chunk];
  const uint next = chunk + 1 < chunk_count ? bases[chunk + 1] : ray_count;
  chunks[chunk] = uvec2(pairs[base].x, chunk);
  sizes[chunk] = next - base;
}
