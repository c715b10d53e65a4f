#version 460
// variants: hierarchy/bounds
// Tests the nodes of the top level against the objects' bounding spheres (sections 3.2.1 and 3.2.5). The result is a
// bit an object, 32 in a word.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
layout(local_size_x = 64) in;
#include "lib/counters.glsl"
#include "lib/invocation.glsl"
#include "shared/node.h"
#include "variant.glsl"

layout(push_constant, scalar) uniform Push {
  uint first_node;
  uint node_count;
  uint object_count;
  uint use_interval;
  uint counter;
  uint first_account;  // of the level's node 0
};
layout(binding = 0, scalar) readonly buffer Nodes { BOUND nodes[]; };
layout(binding = 1, scalar) readonly buffer Intervals { Interval intervals[]; };
layout(binding = 2, scalar) readonly buffer Spheres { vec4 object_spheres[]; };
layout(binding = 3, scalar) writeonly buffer MeshHits { uint mesh_hits[]; };
layout(binding = 4, scalar) buffer Counters { uvec2 counters[]; };
#define ACCOUNT_BINDING 5
#include "lib/account.glsl"

void main() {
  uint i = invocation_index();
  uint words = (object_count + 31u) / 32u;
  if (i >= node_count * words) return;
  uint word = i / node_count, node = i % node_count;
  BOUND ray_node = nodes[first_node + node];
  Interval interval = intervals[first_node + node];
  uint first = word * 32u, count = min(32u, object_count - first);
  uint bits = 0u, k = 0u;
  for (;;) {
    bits |= bound_may_hit_sphere(ray_node, interval, object_spheres[first + k], use_interval == 1u) ? 1u << k : 0u;
    if (++k >= count) break;
  }
  mesh_hits[node * words + word] = bits;
  ADD_COUNTER(counter, count)
  ACCOUNT(tests_object, first_account + first_node + node, count)
}
