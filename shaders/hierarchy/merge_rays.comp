#version 460
// variants: hierarchy/bounds
// Nodes of level 1, merged ray by ray: equations 1 to 4 for the cone, 7 and 8 for the sphere (section 3.2.4).
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "hierarchy/nodes.glsl"

void main() {
  uint i = invocation_index();
  if (i >= node_count) return;
  Ray ray = sorted_ray(ranges[i].x);
  BOUND node = bound_of_ray(ray);
  float far_end = ray.origin.w;
  uint child = ranges[i].x + 1u, end = ranges[i].y;
  while (child < end) {  // SwiftShader of 2024 goes wrong where the test is at the loop's end
    ray = sorted_ray(child);
    node = bound_merge_ray(node, ray);
    far_end = max(far_end, ray.origin.w);
    ++child;
  }
  store(i, node, far_end);
}
