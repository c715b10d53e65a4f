#version 460
// variants: hierarchy/bounds
// Tests the nodes of the top level against triangles (section 3.2.5, equation 9). A lane takes one node and one block
// of at most 32 triangles of an object, and skips the block where the node misses the object. Neighbouring lanes have
// neighbouring nodes and the same block, so that they read the same triangles.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#include "lib/shuffle_read.glsl"
layout(local_size_x = 64) in;
#include "lib/counters.glsl"
#include "lib/invocation.glsl"
#include "shared/node.h"
#include "variant.glsl"

layout(push_constant, scalar) uniform Push {
  uint first_node;
  uint node_count;
  uint padded_nodes;  // node_count rounded up to whole subgroups, so that no subgroup has two blocks
  uint first_block;
  uint block_count;
  uint words;  // of mesh_hits a node; 0: no mesh culling
  uint use_interval;
  uint tests_counter;
  uint hits_counter;
  uint first_account;  // of the level's node 0
};
layout(binding = 0, scalar) readonly buffer Nodes { BOUND nodes[]; };
layout(binding = 1, scalar) readonly buffer Intervals { Interval intervals[]; };
layout(binding = 2, scalar) readonly buffer Blocks { uvec4 blocks[]; };  // object, first triangle, triangles
layout(binding = 3, scalar) readonly buffer TriangleSpheres { vec4 triangle_spheres[]; };
layout(binding = 4, scalar) readonly buffer MeshHits { uint mesh_hits[]; };
layout(binding = 5, scalar) writeonly buffer Masks { uint masks[]; };    // node-major
layout(binding = 6, scalar) writeonly buffer Counts { uint counts[]; };  // of the masks' bits
layout(binding = 7, scalar) buffer Counters { uvec2 counters[]; };
#define ACCOUNT_BINDING 8
#include "lib/account.glsl"
layout(binding = 9, scalar) readonly buffer CornersA { vec4 corner_a[]; };
layout(binding = 10, scalar) readonly buffer CornersB { vec4 corner_b[]; };
layout(binding = 11, scalar) readonly buffer CornersC { vec4 corner_c[]; };
#include "traversal/volumes.glsl"

void main() {
  uint i = invocation_index();
  uint place = i / padded_nodes;
  bool present = place < block_count && i % padded_nodes < node_count;
  uint block_index = min(place, block_count - 1u), node = min(i % padded_nodes, node_count - 1u);
  uvec4 block = blocks[first_block + block_index];
  uint count = present ? block.z : 0u;
  if (words > 0u) {
    uint word = mesh_hits[node * words + (block.x >> 5u)];
    count = (word >> (block.x & 31u)) % 2u == 1u ? count : 0u;
  }
  BOUND ray_node = nodes[first_node + node];
  Interval interval = intervals[first_node + node];

  uint mask = 0u;
  bool common_list = same_list(block.y, block.z);
  uint own_end = common_list ? 0u : count;
  if (own_end > 0u) {
    uint k = 0u;
    for (;;) {
      mask |= may_hit(ray_node, interval, load_volume(block.y + k), use_interval == 1u) ? 1u << k : 0u;
      if (++k >= own_end) break;
    }
  }
  uint common_end = common_list && any_lane(count > 0u) ? block.z : 0u;
  if (common_end > 0u) {
    uint first = 0u;
    for (;;) {
      Volume mine = load_volume(block.y + min(first + gl_SubgroupInvocationID, block.z - 1u));
      uint loaded = min(gl_SubgroupSize, block.z - first), k = 0u;
      for (;;) {
        mask |= may_hit(ray_node, interval, passed_round(mine, k), use_interval == 1u) ? 1u << (first + k) : 0u;
        if (++k >= loaded) break;
      }
      first += gl_SubgroupSize;
      if (first >= common_end) break;
    }
  }

  mask = count > 0u ? mask : 0u;
  uint hits = bitCount(mask);
  if (present) {
    masks[node * block_count + block_index] = mask;
    counts[node * block_count + block_index] = hits;
  }
  ADD_COUNTER(tests_counter, count)
  ADD_COUNTER(hits_counter, hits)
  ACCOUNT(tests_node, first_account + first_node + node, count)
}
