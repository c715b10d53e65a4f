#version 460
// Second half of a pass of the stable radix sort (section 3.2.3). Each lane walks its run in order and puts every pair
// at the place that the scanned histogram has for the lane's next pair with this digit. So equal digits keep their
// order.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "primitives/sort_pass.glsl"

layout(constant_id = 1) const bool values_only = false;  // the last pass may leave the keys out
layout(constant_id = 2) const bool unstable = false;     // test-only fault: all lanes but the last walk backwards

layout(scalar, binding = 1) buffer Places { uint places[]; };  // the histogram after its exclusive scan
// One buffer, for pairs or for values alone.
layout(scalar, binding = 2) writeonly buffer SortedPairs { uvec2 sorted[]; }
as_pairs;
layout(scalar, binding = 2) writeonly buffer SortedValues { uint sorted[]; }
as_values;

void put(uvec2 pair, uint lane) {
  const uint slot = sort_slot(pair.x, lane);
  const uint place = places[slot];
  places[slot] = place + 1;
  if (values_only) as_values.sorted[place] = pair.y;
  else as_pairs.sorted[place] = pair;
}

void main() {
  const uint lane = invocation_index();
  if (lane >= lanes) return;
  const uint begin = part_begin(lane), end = part_end(lane);
  const bool backwards = unstable && lane + 1 < lanes;
  for (uint i = begin; i < end; i += unroll) {
    uvec2 loaded[unroll];
    for (uint k = 0; k < unroll; ++k) loaded[k] = pairs[backwards ? begin + end - 1 - i - k : i + k];
    for (uint k = 0; k < unroll; ++k) put(loaded[k], lane);
  }
}
