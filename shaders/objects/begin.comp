#version 460
// Makes a cluster of each triangle, in Morton order. Lane: a place in the order.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"
#include "objects/clusters.glsl"

layout(push_constant, scalar) uniform Push { uint count; };
layout(binding = 0, scalar) readonly buffer CornersA { vec4 corner_a[]; };
layout(binding = 1, scalar) readonly buffer CornersB { vec4 corner_b[]; };
layout(binding = 2, scalar) readonly buffer CornersC { vec4 corner_c[]; };
layout(binding = 3, scalar) readonly buffer Order { uint order[]; };
layout(binding = 4, scalar) writeonly buffer Low { vec4 cluster_low[]; };
layout(binding = 5, scalar) writeonly buffer High { vec4 cluster_high[]; };

void main() {
  uint i = invocation_index();
  if (i >= count) return;
  uint triangle = order[i];
  Box box = box_of(corner_a[triangle].xyz, corner_b[triangle].xyz, corner_c[triangle].xyz);
  Cluster cluster = Cluster(box, child_is_leaf | triangle, 1u);
  cluster_low[i] = low_of(cluster);
  cluster_high[i] = high_of(cluster);
}
