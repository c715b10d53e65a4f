#version 460
// The sum of each lane's run of elements: the upward half of a prefix sum (sections 3.2.2 and 3.2.3, "scan operator").
// Each lane walks its own run, four elements a load, so that nothing depends on the subgroup's size.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/invocation.glsl"

layout(local_size_x_id = 0) in;
layout(constant_id = 1) const uint run_quads = 64;  // elements of a run ÷ 4

layout(scalar, binding = 0) readonly buffer Source { uvec4 source[]; };
layout(scalar, binding = 1) writeonly buffer Sums { uint sums[]; };
layout(scalar, push_constant) uniform Push { uint quads, lanes, first_lane; };

void main() {
  const uint lane = invocation_index();
  if (lane >= lanes) return;
  const uint end = min((lane + 1) * run_quads, quads);
  uvec4 sum = uvec4(0);
  for (uint i = lane * run_quads; i < end; ++i) sum += source[i];
  sums[first_lane + lane] = sum.x + sum.y + sum.z + sum.w;
}
