#version 460
// Keys from a file in place of a hash (--key file): the key-value pairs of a segment, as rays/hash.comp makes them.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/invocation.glsl"

layout(local_size_x = 64) in;
layout(scalar, binding = 0) readonly buffer Given { uint given[]; };
layout(scalar, binding = 1) writeonly buffer Pairs { uvec2 pairs[]; };  // key, ray
layout(scalar, push_constant) uniform Push {
  uint first;    // ray of the segment
  uint count;    // rays of the segment
  uint segment;  // its number, shifted above the keys
};

void main() {
  if (invocation_index() >= count) return;
  const uint ray = first + invocation_index();
  pairs[ray] = uvec2(segment | given[ray], ray);
}
