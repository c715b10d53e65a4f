#version 460
// variants: hierarchy/bounds
// One level down (section 3.2.5): a lane takes one child node and walks the triangles that its parent may hit.
// Children of one parent are neighbouring lanes and read the same triangles.
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
#include "traversal/descend.glsl"

layout(push_constant, scalar) uniform Push {
  Slice slice;
  uint use_interval;
  uint tests_counter;
  uint hits_counter;
  uint first_account;  // of the level's node 0
};
layout(binding = 0, scalar) readonly buffer Nodes { BOUND nodes[]; };
layout(binding = 1, scalar) readonly buffer Intervals { Interval intervals[]; };
layout(binding = 2, scalar) readonly buffer Children { uvec2 children_of[]; };
layout(binding = 3, scalar) readonly buffer Bases { uint bases[]; };
layout(binding = 4, scalar) readonly buffer Pairs { HitPair pairs[]; };
layout(binding = 5, scalar) readonly buffer TriangleSpheres { vec4 triangle_spheres[]; };
layout(binding = 6, scalar) writeonly buffer Masks { uint masks[]; };
layout(binding = 7, scalar) writeonly buffer Counts { uint counts[]; };
layout(binding = 8, scalar) buffer Counters { uvec2 counters[]; };
#define ACCOUNT_BINDING 9
#include "lib/account.glsl"
layout(binding = 10, scalar) readonly buffer CornersA { vec4 corner_a[]; };
layout(binding = 11, scalar) readonly buffer CornersB { vec4 corner_b[]; };
layout(binding = 12, scalar) readonly buffer CornersC { vec4 corner_c[]; };
#include "traversal/volumes.glsl"

void main() {
  uint i = invocation_index();
  uint place = min(i / slice.arity, slice.parent_count - 1u);
  uvec2 children = children_of[slice.first_parent + place];
  uint child_place = i % slice.arity;
  bool present = i / slice.arity < slice.parent_count && children.x + child_place < children.y;
  uint child = min(children.x + child_place, children.y - 1u);
  uint base = slice.first_base + place;
  List list =
      list_of(slice, bases[base] - slice.pairs_before, bases[base + 1u] - slice.pairs_before, place, child_place);
  BOUND ray_node = nodes[child];
  Interval interval = intervals[child];

  uint hits = 0u;
  uint word = list.first_mask;
  bool common_list = same_list(list.begin, list.end);
  uint own_end = common_list || !present ? list.begin : list.end;
  uint begin = list.begin;
  if (begin < own_end) {
    for (;;) {
      uint count = min(32u, list.end - begin), mask = 0u, k = 0u;
      for (;;) {
        Volume volume = load_volume(pairs[begin + k].triangle);
        mask |= may_hit(ray_node, interval, volume, use_interval == 1u) ? 1u << k : 0u;
        if (++k >= count) break;
      }
      masks[word++] = mask;
      hits += bitCount(mask);
      begin += 32u;
      if (begin >= own_end) break;
    }
  }
  if (common_list && list.begin < list.end) {
    for (;;) {
      uint count = min(32u, list.end - begin), mask = 0u, first = 0u;
      for (;;) {
        Volume mine = load_volume(pairs[begin + min(first + gl_SubgroupInvocationID, count - 1u)].triangle);
        uint loaded = min(gl_SubgroupSize, count - first), k = 0u;
        for (;;) {
          mask |= may_hit(ray_node, interval, passed_round(mine, k), use_interval == 1u) ? 1u << (first + k) : 0u;
          if (++k >= loaded) break;
        }
        first += gl_SubgroupSize;
        if (first >= count) break;
      }
      if (present) masks[word++] = mask;
      hits += bitCount(mask);
      begin += 32u;
      if (begin >= list.end) break;
    }
  }

  hits = present ? hits : 0u;
  if (present) counts[child - slice.first_child] = hits;
  uint tests = present ? list.end - list.begin : 0u;
  ADD_COUNTER(tests_counter, tests)
  ADD_COUNTER(hits_counter, hits)
  ACCOUNT(tests_node, first_account + child, tests)
}
