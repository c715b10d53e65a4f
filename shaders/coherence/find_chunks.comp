#version 460
// Finds the chunk (section 3.2.3, Figure 5) that begins at each of the given rays, the first ones of segments.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/invocation.glsl"
#include "coherence/rising.glsl"  // the chunk bases

layout(local_size_x = 64) in;
layout(scalar, binding = 1) buffer Firsts { uint firsts[]; };  // in: a ray; out: its chunk
layout(scalar, push_constant) uniform Push { uint count, chunk_count; };

void main() {
  const uint i = invocation_index();
  if (i < count) firsts[i] = last_not_above(firsts[i], chunk_count);
}
