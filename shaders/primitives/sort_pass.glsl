// What both halves of a radix sort's pass share.
#include "lib/invocation.glsl"

layout(local_size_x_id = 0) in;

layout(scalar, binding = 0) readonly buffer Pairs { uvec2 pairs[]; };  // key, value
layout(scalar, push_constant) uniform Push { uint count, lanes, run, shift, mask; };

/// Where the histogram counts this key in the column of `lane`: digit-major, so that a plain scan gives the places.
uint sort_slot(uint key, uint lane) { return ((key >> shift) & mask) * lanes + lane; }
