#version 460
// variants: hierarchy/bounds
// One level down (section 3.2.5): a lane takes one child node and walks the triangles that its parent may hit.
// Children of one parent are neighbouring lanes and read the same triangles.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
layout(local_size_x = 64) in;
#include "lib/counters.glsl"
#include "lib/invocation.glsl"
#include "shared/node.h"
#include "variant.glsl"
#include "traversal/descend.glsl"

layout(push_constant, scalar) uniform Push {
  Portion portion;
  uint use_interval;
  uint tests_counter;
  uint hits_counter;
};
layout(binding = 0, scalar) readonly buffer Nodes { Node nodes[]; };
layout(binding = 1, scalar) readonly buffer Intervals { Interval intervals[]; };
layout(binding = 2, scalar) readonly buffer Parents { uint parents[]; };
layout(binding = 3, scalar) readonly buffer Children { uvec2 children_of[]; };
layout(binding = 4, scalar) readonly buffer Bases { uint bases[]; };
layout(binding = 5, scalar) readonly buffer Pairs { HitPair pairs[]; };
layout(binding = 6, scalar) readonly buffer TriangleSpheres { vec4 triangle_spheres[]; };
layout(binding = 7, scalar) writeonly buffer Masks { uint masks[]; };
layout(binding = 8, scalar) writeonly buffer Counts { uint counts[]; };
layout(binding = 9, scalar) buffer Counters { uvec2 counters[]; };

void main() {
  uint i = invocation_index();
  if (i >= portion.child_count) return;
  uint child = portion.first_child + i;
  uint parent = parents[child];
  uint place = parent - portion.first_parent;
  uint base = portion.first_base + place;
  List list = list_of(portion, bases[base] - portion.pairs_before, bases[base + 1u] - portion.pairs_before, place,
                      child - children_of[parent].x);
  Node ray_node = nodes[child];
  Interval interval = intervals[child];
  uint hits = 0u;
  uint word = list.first_mask;
  for (uint begin = list.begin; begin < list.end; begin += 32u) {
    uint count = min(32u, list.end - begin);
    uint mask = 0u;
    for (uint k = 0u; k < count; ++k) {
      vec4 sphere = triangle_spheres[pairs[begin + k].triangle];
      if (bound_may_hit_sphere(ray_node, interval, sphere, use_interval == 1u)) mask |= 1u << k;
    }
    masks[word++] = mask;
    hits += bitCount(mask);
  }
  counts[i] = hits;
  ADD_COUNTER(tests_counter, list.end - list.begin)
  ADD_COUNTER(hits_counter, hits)
}
