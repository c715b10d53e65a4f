#version 460
// variants: hierarchy/bounds
// Groups, the nodes of level 2, through the top of the object hierarchy: depth first, the nearer child first, down to
// small subtrees, which are the group's frontier (shared/walk.h). Where the frontier has no more room or a walk gets too
// long, what was left for later becomes frontier as it is. Lane: a group.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
layout(local_size_x = 64) in;
#include "lib/counters.glsl"
#include "lib/invocation.glsl"
#include "lib/visit.glsl"
#include "shared/node.h"
#include "shared/walk.h"
#include "variant.glsl"
#include "hierarchy/ready.glsl"

layout(push_constant, scalar) uniform Push {
  uint first_group;
  uint group_count;
  uint use_interval;
  uint box_counter;
  uint first_account;  // of the level's node 0
};
layout(binding = 0, scalar) readonly buffer Nodes { BOUND nodes[]; };
layout(binding = 1, scalar) readonly buffer Intervals { Interval intervals[]; };
layout(binding = 2, scalar) readonly buffer BoxLow { vec4 box_low[]; };
layout(binding = 3, scalar) readonly buffer BoxHigh { vec4 box_high[]; };
layout(binding = 4, scalar) writeonly buffer Frontiers { uvec2 frontier[]; };
layout(binding = 5, scalar) buffer Counters { uvec2 counters[]; };
#define ACCOUNT_BINDING 6
#include "lib/account.glsl"

/// Most inner nodes that a group visits: lavapipe 22.3 ends loops silently.
const uint most_visits = 1024u;
const uint most_entries = frontier_room - 1u;
/// In the stack: a slot with a small subtree.
const uint is_small = 1u << 31;

/// Slots to be visited later, and from which distance on.
uvec2 stack[most_entries];

/// A child slot as the stack has it; x is `none` where no ray of the group may hit its box.
uvec2 tested(READY group, float reach, uint slot) {
  vec4 low = box_low[slot], high = box_high[slot];
  float enter;
  bool hit = ready_may_hit_box(group, reach, low.xyz, high.xyz, enter);
  uint visit = visit_of(low.w, high.w);
  bool small = floatBitsToUint(high.w) <= frontier_triangles || !is_inner(visit);
  return uvec2(hit && visit != none ? slot | (small ? is_small : 0u) : none, floatBitsToUint(enter));
}

void main() {
  uint i = invocation_index();
  if (i >= group_count) return;
  READY group = ready(nodes[first_group + i], use_interval == 1u);
  float reach = use_interval == 1u ? intervals[first_group + i].far_end : 3e38;
  uint first = i * frontier_room + 1u, count = 0u, depth = 0u, visits = 0u;
  uint next = 0u;                // inner node
  uvec2 as_entry = uvec2(none);  // the same as it came from the stack
  do {
    uvec2 a = tested(group, reach, 2u * next), b = tested(group, reach, 2u * next + 1u);
    bool swapped = uintBitsToFloat(b.y) < uintBitsToFloat(a.y);
    uvec2 nearer = swapped ? b : a, farther = swapped ? a : b;
    ++visits;
    stack[depth] = farther;
    depth += farther.x != none ? 1u : 0u;
    stack[depth] = nearer;
    depth += nearer.x != none ? 1u : 0u;
    next = none;
    if (depth > 0u) {
      do {
        as_entry = stack[--depth];
        if ((as_entry.x & is_small) != 0u) {
          frontier[first + count] = uvec2(as_entry.x & ~is_small, as_entry.y);
          ++count;
        } else {
          next = floatBitsToUint(box_low[as_entry.x].w);
        }
      } while (next == none && depth > 0u);
    }
  } while (next != none && visits < most_visits && count + depth + 2u <= most_entries);
  if (next != none) stack[depth++] = as_entry;
  while (depth > 0u) {
    uvec2 entry = stack[--depth];
    frontier[first + count] = uvec2(entry.x & ~is_small, entry.y);
    ++count;
  }
  frontier[first - 1u] = uvec2(count, 0u);
  ADD_COUNTER(box_counter, 2u * visits)
  ACCOUNT(tests_object, first_account + first_group + i, 2u * visits)
}
