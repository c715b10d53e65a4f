#version 460
// Ray compression (section 3.2.3, Figure 5), first step: flags the rays whose key differs from that of the ray before;
// the very first ray is flagged, too. Lane: four rays, so that four flags are stored at once.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/invocation.glsl"

layout(local_size_x = 64) in;
layout(scalar, binding = 0) readonly buffer Pairs { uvec2 pairs[]; };  // key, ray
layout(scalar, binding = 1) writeonly buffer Flags { uvec4 flags[]; };
layout(scalar, push_constant) uniform Push { uint count; };

void main() {
  const uint quad = invocation_index();
  if (4 * quad >= count) return;
  const uint first = 4 * quad, last = count - 1;  // past the last ray the key does not change
  const uint before = pairs[max(first, 1) - 1].x;
  const uint a = pairs[first].x, b = pairs[min(first + 1, last)].x;
  const uint c = pairs[min(first + 2, last)].x, d = pairs[min(first + 3, last)].x;
  flags[quad] = uvec4(first == 0 || a != before, b != a, c != b, d != c);
}
