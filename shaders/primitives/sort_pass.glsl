// What the two halves of a pass of the radix sort have in common.
#include "lib/invocation.glsl"

layout(local_size_x_id = 0) in;
const uint unroll = 4;  // pairs loaded together

layout(scalar, binding = 0) readonly buffer Pairs { uvec2 pairs[]; };  // key, value
layout(scalar, push_constant) uniform Push {
  uint count, lanes, run;  // pairs, and how many of them a lane walks; multiples of `unroll`
  uint first, steps;       // the part of each lane's run that this dispatch walks: long loops are split (lavapipe 22.3)
  uint shift, mask;        // of the digit
};

/// Where the lane's part of its run begins and ends.
uint part_begin(uint lane) { return lane * run + first; }
uint part_end(uint lane) { return min(lane * run + min(first + steps, run), count); }

/// The element of the histogram that counts this key's digit for `lane`. All lanes of one digit follow one another, so
/// that a scan of the histogram gives the places of pairs.
uint sort_slot(uint key, uint lane) { return ((key >> shift) & mask) * lanes + lane; }
