#version 460
// variants: hierarchy/bounds
// Walks groups, the nodes of level 2, through the top of the object hierarchy: depth first, the nearer child first,
// down to small subtrees, which make up the group's frontier (shared/walk.h). Where a frontier is full or a walk gets
// too long, the subtrees that are not visited yet are put into the frontier as they are.
//
// Lane: a group. A cluster of lanes, whose groups are neighbours, walks together: it visits what any of them needs, and
// a lane tests only what it needs itself. So one lane loads each box, for all of them. In the "-no-shuffle" build every
// lane walks by itself.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#include "lib/shuffle_read.glsl"
layout(local_size_x = 64) in;
#ifdef CRSH_NO_SHUFFLE
const uint cluster = 1u;
#else
const uint cluster = 4u;
#endif
#include "lib/cluster.glsl"
#include "lib/counters.glsl"
#include "lib/visit.glsl"
#include "shared/node.h"
#include "shared/walk.h"
#include "variant.glsl"
#include "hierarchy/prepared.glsl"

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

/// Most inner nodes that a cluster visits: lavapipe 22.3 ends loops silently after 65,535 turns.
const uint max_visits = 1024u;
const uint max_entries = frontier_room - 1u;

/// A child slot that one or more lanes of the cluster are to visit.
struct Entry {
  uint slot;    // `none`: no lane has anything to visit
  bool small;   // a small subtree
  bool mine;    // this lane's group may have rays in its box
  float enter;  // before this distance none of its rays is in the box
};

/// Flags that an entry of the stack has beside the slot.
const uint is_small = 1u << 31, is_mine = 1u << 30;
uvec2 stack[max_entries];

uvec2 packed(Entry entry) {
  return uvec2(entry.slot | (entry.small ? is_small : 0u) | (entry.mine ? is_mine : 0u), floatBitsToUint(entry.enter));
}

Entry unpacked(uvec2 word) {
  return Entry(word.x & ~(is_small | is_mine), (word.x & is_small) != 0u, (word.x & is_mine) != 0u,
               uintBitsToFloat(word.y));
}

/// The boxes of both children, of the slots 2 * node and after.
#ifdef CRSH_NO_SHUFFLE
#define BOXES(node, low0, high0, low1, high1)                                                  \
  vec4 low0 = box_low[2u * node], high0 = box_high[2u * node], low1 = box_low[2u * node + 1u], \
       high1 = box_high[2u * node + 1u];
#else
#define BOXES(node, low0, high0, low1, high1)                                                        \
  uint own_slot_ = 2u * node + (lane_in_cluster() >> 1u);                                            \
  vec4 own_ = vec4(0.0);                                                                             \
  if ((lane_in_cluster() & 1u) == 0u) own_ = box_low[own_slot_];                                     \
  else own_ = box_high[own_slot_];                                                                   \
  vec4 low0 = FROM_LANE(own_, first_of_cluster()), high0 = FROM_LANE(own_, first_of_cluster() + 1u), \
       low1 = FROM_LANE(own_, first_of_cluster() + 2u), high1 = FROM_LANE(own_, first_of_cluster() + 3u);
#endif

/// The entry of a child's box, tested where `wanted`: where this lane's group may have rays in the parent's box.
Entry tested(PREPARED group, float reach, bool wanted, uint slot, vec4 low, vec4 high) {
  float enter;
  bool hit = wanted && prepared_may_hit_box(group, reach, low.xyz, high.xyz, enter);
  uint visit = visit_of(low.w, high.w);
  bool small = floatBitsToUint(high.w) <= frontier_triangles || !is_inner(visit);
  return Entry(slot, small, hit && visit != none, enter);
}

uint first, count;  // of this lane's list

void put(Entry entry) {
  if (entry.mine) {
    frontier[first + count] = uvec2(entry.slot, floatBitsToUint(entry.enter));
    ++count;
  }
}

/// What is left on the stack joins the frontier unwalked.
void put_stack(uint depth) {
  if (depth > 0u) {
    for (;;) {
      put(unpacked(stack[--depth]));
      if (depth == 0u) break;
    }
  }
}

void main() {
  uint i = lane_place();
  bool present = i < group_count;
  uint group_index = first_group + min(i, group_count - 1u);
  PREPARED group = prepare(nodes[group_index], use_interval == 1u);
  float reach = use_interval == 1u ? intervals[group_index].far_end : 3e38;
  first = i * frontier_room + 1u;
  count = 0u;
  uint depth = 0u, visits = 0u, tests = 0u;
  uint next = 0u;                                  // inner node
  Entry entry = Entry(none, false, present, 0.0);  // the same as a slot
  for (;;) {
    BOXES(next, low0, high0, low1, high1)
    Entry a = tested(group, reach, entry.mine, 2u * next, low0, high0);
    Entry b = tested(group, reach, entry.mine, 2u * next + 1u, low1, high1);
    uint enter_a = least_of_lanes(a.mine ? floatBitsToUint(a.enter) : none);
    uint enter_b = least_of_lanes(b.mine ? floatBitsToUint(b.enter) : none);
    tests += entry.mine ? 2u : 0u;
    ++visits;
    bool swapped = enter_b < enter_a;
    Entry nearer = swapped ? b : a, farther = swapped ? a : b;
    stack[depth] = packed(farther);
    depth += max(enter_a, enter_b) != none ? 1u : 0u;
    next = none;
    bool in_hand = min(enter_a, enter_b) != none;
    entry = nearer;
    uint inner = floatBitsToUint(swapped ? low1.w : low0.w);
    if (!in_hand && depth > 0u) {
      entry = unpacked(stack[--depth]);
      in_hand = true;
      inner = none;
    }
    if (in_hand) {
      for (;;) {
        in_hand = entry.small && depth > 0u;
        if (entry.small) {
          put(entry);
          if (in_hand) entry = unpacked(stack[--depth]);
          inner = none;
        } else {
          if (inner == none) inner = floatBitsToUint(box_low[entry.slot].w);
          next = inner;
        }
        if (!in_hand) break;
      }
    }
    bool room = lanes_of_cluster(count + depth + 2u > max_entries) == 0u;
    if (!(next != none && visits < max_visits && room)) break;
  }
  if (next != none) put(entry);
  put_stack(depth);
  if (present) frontier[first - 1u] = uvec2(count, 0u);
  ADD_COUNTER(box_counter, tests)
  if (present) {
    ACCOUNT(tests_object, first_account + group_index, tests)
  }
}
