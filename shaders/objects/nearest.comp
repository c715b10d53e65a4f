#version 460
// Parallel locally-ordered clustering (Meister and Bittner 2018): each cluster looks for the neighbour, up to `radius`
// places away in Morton order, with which it would have the smallest box. Lane: a cluster.
//
// Of equal areas that pair wins which comes first in one order of all pairs: by distance in the list; then, for an odd
// distance, those that begin at an even place; then by place. So the first pair of all chooses each other, every round
// merges something, and clusters that are all alike merge by twos.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"
#include "objects/clusters.glsl"

layout(push_constant, scalar) uniform Push {
  uint first;  // cluster of this dispatch
  uint end;
  uint count;   // clusters in all
  uint radius;  // 0: every two neighbours merge, whatever their boxes
};
layout(binding = 0, scalar) readonly buffer Low { vec4 cluster_low[]; };
layout(binding = 1, scalar) readonly buffer High { vec4 cluster_high[]; };
layout(binding = 2, scalar) writeonly buffer Nearest { uint nearest[]; };

/// The area of both boxes merged; infinite where it is not a number, so that comparing areas is an order.
float area_with(Box own, uint other) {
  float area = half_area(merged(own, Box(cluster_low[other].xyz, cluster_high[other].xyz)));
  return area >= 0.0 ? area : uintBitsToFloat(0x7F800000u);
}

void main() {
  uint i = first + invocation_index();
  if (i >= end) return;
  Box own = Box(cluster_low[i].xyz, cluster_high[i].xyz);
  uint best = (i ^ 1u) < count ? i ^ 1u : i;
  float least = radius == 0u ? 0.0 : uintBitsToFloat(0x7F800000u);
  if (best == i && radius != 0u && i > 0u) best = i - 1u;
  for (uint k = 1u; k <= radius; ++k) {
    bool upwards_first = (k & 1u) == 1u && (i & 1u) == 0u;
    uint up = i + k, down = i - k;
    bool has_up = up < count, has_down = k <= i;
    uint one = upwards_first ? up : down, two = upwards_first ? down : up;
    bool has_one = upwards_first ? has_up : has_down, has_two = upwards_first ? has_down : has_up;
    float area_one = has_one ? area_with(own, one) : least;
    if (area_one < least) least = area_one, best = one;
    float area_two = has_two ? area_with(own, two) : least;
    if (area_two < least) least = area_two, best = two;
  }
  nearest[i] = best;
}
