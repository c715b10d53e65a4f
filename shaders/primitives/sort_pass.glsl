// What both halves of a radix sort's pass share.
#include "lib/invocation.glsl"

layout(local_size_x_id = 0) in;
const uint unroll = 4;  // pairs loaded together

layout(scalar, binding = 0) readonly buffer Pairs { uvec2 pairs[]; };  // key, value
layout(scalar, push_constant) uniform Push {
  uint count, lanes, run;  // pairs, and how many of them a lane walks; multiples of `unroll`
  uint first, steps;       // of its run a lane walks this part in this dispatch: loops must stay short
  uint shift, mask;        // of the digit
};

/// Where the lane's part of its run begins and ends.
uint part_begin(uint lane) { return lane * run + first; }
uint part_end(uint lane) { return min(lane * run + min(first + steps, run), count); }

/// Where the histogram counts this key in the column of `lane`: digit-major, so that a plain scan gives the places.
uint sort_slot(uint key, uint lane) { return ((key >> shift) & mask) * lanes + lane; }
