#version 460
// variants: hierarchy/bounds
// Nodes of any level, each fitted to all rays below it instead of merged (--fit all).
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "hierarchy/nodes.glsl"

void main() {
  uint i = invocation_index();
  if (i >= node_count) return;
  uint begin = ranges[i].x, end = ranges[i].y;
  float far_end = 0.0;
  for (uint ray = begin; ray < end; ++ray) far_end = max(far_end, sorted_ray(ray).origin.w);
  store(i, bound_fit(begin, end), far_end);
}
