#version 460
// The prefix sums of each lane's run, beginning with the sum of all elements before it: the downward half of a prefix
// sum (sections 3.2.2 and 3.2.3, "scan operator"). Source and destination may be one buffer.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/invocation.glsl"

layout(local_size_x_id = 0) in;
layout(constant_id = 1) const uint run_quads = 64;  // elements of a run ÷ 4
layout(constant_id = 2) const bool inclusive = false;
layout(constant_id = 3) const bool single_run = false;  // nothing comes before it: `before` is not read

layout(scalar, binding = 0) readonly buffer Source { uvec4 source[]; };
layout(scalar, binding = 1) writeonly buffer Destination { uvec4 destination[]; };
layout(scalar, binding = 2) readonly buffer Before { uint before[]; };
layout(scalar, push_constant) uniform Push { uint quads, lanes, first_lane; };

void main() {
  const uint lane = invocation_index();
  if (lane >= lanes) return;
  const uint end = min((lane + 1) * run_quads, quads);
  uint sum = single_run ? 0 : before[first_lane + lane];
  for (uint i = lane * run_quads; i < end; ++i) {
    const uvec4 value = source[i];
    const uint x = sum + value.x;
    const uint y = x + value.y;
    const uint z = y + value.z;
    const uint w = z + value.w;
    destination[i] = inclusive ? uvec4(x, y, z, w) : uvec4(sum, x, y, z);
    sum = w;
  }
}
