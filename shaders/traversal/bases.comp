#version 460
// The first pair of every node of the top level, from the scanned counts of its blocks, and one past the last pair.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"

layout(push_constant, scalar) uniform Push {
  uint count;  // nodes + 1
  uint stride;
};
layout(binding = 0, scalar) readonly buffer Scanned { uint scanned[]; };
layout(binding = 1, scalar) writeonly buffer Bases { uint bases[]; };

void main() {
  uint i = invocation_index();
  if (i < count) bases[i] = scanned[i * stride];
}
