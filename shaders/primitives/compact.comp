#version 460
// The indices of the flags that are set, in order. Each lane writes those of its run, beginning at the place that the
// number of set flags before its run gives (the trimming of Figure 4, and the chunk bases of Figure 5).
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/invocation.glsl"

layout(local_size_x_id = 0) in;
layout(constant_id = 1) const uint run_quads = 64;  // flags of a run ÷ 4

layout(scalar, binding = 0) readonly buffer Flags { uvec4 flags[]; };
layout(scalar, binding = 1) readonly buffer Before { uint before[]; };
layout(scalar, binding = 2) writeonly buffer Indices { uint indices[]; };
layout(scalar, push_constant) uniform Push { uint quads, lanes; };

void main() {
  const uint lane = invocation_index();
  if (lane >= lanes) return;
  const uint end = min((lane + 1) * run_quads, quads);
  uint next = before[lane];
  for (uint i = lane * run_quads; i < end; ++i) {
    const uvec4 flag = flags[i];
    const uint y = next + flag.x;
    const uint z = y + flag.y;
    const uint w = z + flag.z;
    if (flag.x != 0) indices[next] = 4 * i;
    if (flag.y != 0) indices[y] = 4 * i + 1;
    if (flag.z != 0) indices[z] = 4 * i + 2;
    if (flag.w != 0) indices[w] = 4 * i + 3;
    next = w + flag.w;
  }
}
