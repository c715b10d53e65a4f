#version 460
// First half of a pass of the stable radix sort (section 3.2.3): how often each digit occurs in each lane's run of
// pairs. Each lane walks its own run and has a column of the histogram for itself, which must be all zeros before.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "primitives/sort_pass.glsl"

layout(scalar, binding = 1) buffer Histogram { uint histogram[]; };

void main() {
  const uint lane = invocation_index();
  if (lane >= lanes) return;
  const uint end = part_end(lane);
  for (uint i = part_begin(lane); i < end; i += unroll) {
    uint slots[unroll];
    for (uint k = 0; k < unroll; ++k) slots[k] = sort_slot(pairs[i + k].x, lane);
    for (uint k = 0; k < unroll; ++k) histogram[slots[k]]++;
  }
}
