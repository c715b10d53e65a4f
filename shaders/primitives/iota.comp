#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
// out[i] = i: values for a sort that is to give the order of its keys.

#include "lib/invocation.glsl"

layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { uint count; };
layout(binding = 0, scalar) writeonly buffer Numbers { uint numbers[]; };

void main() {
  const uint i = invocation_index();
  if (i < count) numbers[i] = i;
}
