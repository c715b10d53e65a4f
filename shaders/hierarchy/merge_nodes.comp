#version 460
// variants: hierarchy/bounds
// Nodes of level 2 and above, merged child by child: equations 5 to 8 (section 3.2.4).
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "hierarchy/nodes.glsl"

layout(binding = 4, scalar) readonly buffer ChildNodes { BOUND child_nodes[]; };
layout(binding = 5, scalar) readonly buffer ChildIntervals { Interval child_intervals[]; };

void main() {
  uint i = invocation_index();
  if (i >= node_count) return;
  BOUND node = child_nodes[ranges[i].x];
  float far_end = child_intervals[ranges[i].x].far_end;
  uint child = ranges[i].x + 1u, end = ranges[i].y;
  while (child < end) {  // SwiftShader of 2024 goes wrong where the test is at the loop's end
    node = bound_merge(node, child_nodes[child]);
    far_end = max(far_end, child_intervals[child].far_end);
    ++child;
  }
  store(i, node, far_end);
}
