#version 460
// variants: hierarchy/bounds
// Walks level-1 nodes through the object hierarchy, from their groups' frontiers down to the leaves, and tests their
// rays against the triangles that the node may hit. Depth first, the nearer child first, no farther than the rays' hits
// so far, and only until all shadow rays of the node are blocked. (Sections 3.2.5 and 3.2.6, and the paper's future
// work.)
//
// A cluster of lanes takes a node, a ray each. All of them walk alike: what the node needs is loaded once, by one lane
// or another, and passed round; boxes of a frontier and triangles of a leaf are tested side by side. In the
// "-no-shuffle" build a cluster is one lane, which takes the rays in turn: the same hits, after tests in another order.
//
// A node that needs very many tests is given up: its rays are listed, and then go one by one (single.comp).
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#include "lib/shuffle_read.glsl"
layout(local_size_x = 64) in;
#include "intersection/meet.glsl"
#include "lib/counters.glsl"
#include "lib/invocation.glsl"
#include "lib/visit.glsl"
#include "shared/counters.h"
#include "shared/node.h"
#include "shared/walk.h"
#include "variant.glsl"
#include "hierarchy/prepared.glsl"

/// Test-only mutation: about every so many-th pair of node and triangle is dropped.
layout(constant_id = 0) const uint drop_every = 0u;
#ifdef CRSH_NO_SHUFFLE
const uint cluster = 1u;
#else
/// Lanes a node: a power of two, 2 to 32; and rays a lane, so that they hold the arity.
layout(constant_id = 2) const uint cluster = 8u;
layout(constant_id = 3) const uint rows = 1u;
#endif
#include "lib/cluster.glsl"

layout(push_constant, scalar) uniform Push {
  uint first_node;
  uint node_count;
  uint first_group;  // of the frontiers at hand
  uint grouped;      // 0: all nodes begin with the first frontier
  uint clusters;     // each takes every so many-th node
  uint first_ray;    // of the segment
  uint use_interval;
  uint counter_row;  // first counter of the rays' bounce and kind
  uint box_account;  // of the level's node 0
  uint node_account;
  uint triangle_account;  // of ray 0
};
layout(binding = 5, scalar) readonly buffer Rays { Ray rays[]; };     // in sorted order
layout(binding = 6, scalar) readonly buffer Order { uint order[]; };  // creation index a sorted position
layout(binding = 7, scalar) readonly buffer BoxLow { vec4 box_low[]; };
layout(binding = 8, scalar) readonly buffer BoxHigh { vec4 box_high[]; };
layout(binding = 9, scalar) readonly buffer Nodes { vec4 node_words[]; };
layout(binding = 10, scalar) readonly buffer NodeRays { uvec2 rays_of[]; };
layout(binding = 11, scalar) readonly buffer Parents { uint parents[]; };
layout(binding = 12, scalar) readonly buffer Frontiers { uvec2 frontier[]; };
layout(binding = 13, scalar) buffer Unfinished {
  uint unfinished_count;
  uint unfinished[];  // rays, counted from first_ray
};
layout(binding = 14, scalar) buffer Counters { uvec2 counters[]; };
#define ACCOUNT_BINDING 15
#include "lib/account.glsl"

uint box_tests, node_tests, node_hits, ray_tests;  // of this lane, and its rays

#include "intersection/cluster_stack.glsl"
#include "intersection/node_rays.glsl"
#include "intersection/node_bound.glsl"

/// About how many turns of loops a node's walk may take, and those of all nodes of a cluster. lavapipe 22.3 ends loops
/// silently after 65,535 turns, and while one of four clusters of a subgroup takes a turn, five other loops may take
/// one for no lane.
const uint max_turns = 640u, max_turns_in_all = 2560u;
/// A factor for `enter`: but for rounding, no ray hits anything in a box before the distance at which it enters the
/// box.
const float reach_slack = 1.0 + 8.0 * bound_pad;

/// What is still to be visited, in this order: `next`; the stack; those of the frontier's entries that the lanes have
/// tested, one each, and found hit; the frontier's other entries.
struct NodeWalk {
  uint next;    // `none`: nothing yet
  float enter;  // no ray is in its box before this distance
  uint depth;   // of the stack
  uint visit;   // this lane's entry
  float visit_enter;
  uint visits;  // a bit a lane whose entry is an inner node to be visited
  bool leaves;  // some entries are leaves, and first of all
  uint entry;   // of the frontier, not tested yet
  uint entries_end;
  float reach;  // of all rays: nothing beyond can matter; below 0: nothing at all
  uint turns;   // left to take
};

bool is_idle(NodeWalk walk) { return walk.next == none && walk.depth == 0u && walk.visits == 0u && !walk.leaves; }
bool is_left(NodeWalk walk) { return walk.reach >= 0.0 && (!is_idle(walk) || walk.entry < walk.entries_end); }

void spend(inout NodeWalk walk, uint turns) { walk.turns -= min(turns, walk.turns); }

bool within(float enter, float reach) { return enter <= reach * reach_slack; }

/// What to visit for a child slot, `none` where no ray of the node may hit its box.
uint test_slot(PREPARED node, float reach, uint slot, bool wanted, out float enter) {
  vec4 low = vec4(0.0), high = vec4(0.0);
  if (wanted) low = box_low[slot], high = box_high[slot];  // on a CPU each lane's load takes time
  bool hit = prepared_may_hit_box(node, reach, low.xyz, high.xyz, enter);
  return wanted && hit && within(enter, reach) ? visit_of(low.w, high.w) : none;
}

/// Chooses what is visited next, if there is anything within reach.
void take(inout NodeWalk walk) {
  bool stacked = walk.depth > 0u;
  walk.depth -= stacked ? 1u : 0u;
  uint from = uint(findLSB(walk.visits));
  bool visited = !stacked && walk.visits != 0u;
  uint lane = first_of_cluster() + (visited ? from : 0u);
  uint visit = FROM_LANE(walk.visit, lane);
  float enter = FROM_LANE(walk.visit_enter, lane);
  walk.visits &= visited ? walk.visits - 1u : 0xFFFFFFFFu;
  walk.enter = stacked ? stack_enter(walk.depth) : enter;
  visit = stacked ? stack_visit(walk.depth) : visited ? visit : none;
  walk.next = within(walk.enter, walk.reach) ? visit : none;
}

/// Tests the next entries of the frontier, one a lane.
void test_entries(inout NodeWalk walk, PREPARED node) {
  uint mine = walk.entry + lane_in_cluster();
  bool present = mine < walk.entries_end;
  uvec2 entry = uvec2(0u);
  if (present) entry = frontier[mine];
  present = present && within(uintBitsToFloat(entry.y), walk.reach);
  walk.visit = test_slot(node, walk.reach, entry.x, present, walk.visit_enter);
  walk.visits = lanes_of_cluster(is_inner(walk.visit));
  walk.leaves = lanes_of_cluster(walk.visit != none) != walk.visits;
  walk.entry = min(walk.entry + cluster, walk.entries_end);
  box_tests += present ? 1u : 0u;
  spend(walk, 1u);
}

/// Goes from an inner node to the nearer child that the rays may hit; the other one is put on the stack.
void descend(inout NodeWalk walk, PREPARED node) {
  float enter0, enter1;
#ifdef CRSH_NO_SHUFFLE
  uint visit0 = test_slot(node, walk.reach, 2u * walk.next, true, enter0);
  uint visit1 = test_slot(node, walk.reach, 2u * walk.next + 1u, true, enter1);
  box_tests += 2u;
#else
  float enter;
  uint visit = test_slot(node, walk.reach, 2u * walk.next + lane_in_cluster(), lane_in_cluster() < 2u, enter);
  uint visit0 = FROM_LANE(visit, first_of_cluster()), visit1 = FROM_LANE(visit, first_of_cluster() + 1u);
  enter0 = FROM_LANE(enter, first_of_cluster()), enter1 = FROM_LANE(enter, first_of_cluster() + 1u);
  box_tests += lane_in_cluster() < 2u ? 1u : 0u;
#endif
  bool both = visit0 != none && visit1 != none;
  bool first = visit0 != none && !(both && enter1 < enter0);
  put_on_stack(walk.depth, first ? visit1 : visit0, first ? enter1 : enter0);
  walk.depth += both ? 1u : 0u;
  walk.next = first ? visit0 : visit1;
  walk.enter = first ? enter0 : enter1;
  spend(walk, 1u);
  if (walk.next == none) take(walk);
}

/// Tests the triangles of the lanes' leaves (`none`: no leaf) against the node, one in each lane, and then those that
/// the node may hit against its rays.
void meet_leaves(inout NodeWalk walk, PREPARED node, uint leaf, float enter) {
  uint own = leaf_triangles(leaf), end = sum_of_lanes(own), count = FROM_LANE(end, first_of_cluster() + cluster - 1u);
  uint begin = leaf_first(leaf) + own - end;  // of triangle 0 of all, if they were this leaf's
  if (count == 0u) return;
  uint first = 0u;
  for (;;) {
    uint mine = first + lane_in_cluster();
    uint lane = first_of_cluster() + lane_of_sum(end, mine);
    uint place = FROM_LANE(begin, lane) + mine;
    float from = FROM_LANE(enter, lane);
    bool present = mine < count && within(from, walk.reach);
    Loaded loaded = Loaded(none, vec4(0.0), vec4(0.0), vec4(0.0));
    if (present) loaded = load_leaf_triangle(place);
    float met;  // no ray can hit the triangle before this distance
    bool may = present && prepared_may_hit_corners(node, walk.reach, loaded.a.xyz, loaded.b.xyz, loaded.c.xyz, met);
    node_tests += present ? 1u : 0u;
    node_hits += may ? 1u : 0u;
    may = may && (drop_every == 0u || (place + 7u * node_rays.x) % drop_every != 0u);
    spend(walk, 1u);
    // Distance, a little rounded down, and lane in one word, so that one search finds both; `none`: may not hit.
    uint own_turn = may ? (floatBitsToUint(met) & ~(cluster - 1u)) | lane_in_cluster() : none;
    uint nearest = least_of_lanes(own_turn);
    if (nearest != none) {
      for (;;) {
        uint of_lane = nearest & (cluster - 1u);
        meet_rays(passed_round(loaded, first_of_cluster() + of_lane), uintBitsToFloat(nearest & ~(cluster - 1u)));
        spend(walk, turns_of_rays());
        own_turn = lane_in_cluster() == of_lane ? none : own_turn;
        nearest = least_of_lanes(own_turn);
        if (nearest == none) break;
      }
      walk.reach = reach_of_rays();
      spend(walk, turns_of_rays());
    }
    first += cluster;
    if (first >= count) break;
  }
}

/// Walks one node, with at most so many turns. Returns whether it was finished.
bool walk_node(uint node, inout uint turns) {
  take_rays(node);
  PREPARED bound = prepare(load_bound(node), use_interval == 1u);
  uint list = (grouped == 1u ? parents[node] - first_group : 0u) * frontier_room;
  NodeWalk walk = NodeWalk(none, 0.0, 0u, none, 0.0, 0u, false, list + 1u, list + 1u + frontier[list].x,
                           reach_of_rays(), min(turns, max_turns));
  turns -= walk.turns;
  for (;;) {
    if (is_idle(walk) && walk.entry < walk.entries_end) {
      for (;;) {
        test_entries(walk, bound);
        if (!(is_idle(walk) && walk.entry < walk.entries_end)) break;
      }
    }
    bool entered = walk.leaves;
    if (!entered && walk.next == none) take(walk);
    if (!entered && is_inner(walk.next)) {
      for (;;) {
        descend(walk, bound);
        if (!(is_inner(walk.next) && walk.turns > 0u && walk.depth < max_stack)) break;
      }
    }
    uint leaf = lane_in_cluster() == 0u ? walk.next : none;
    meet_leaves(walk, bound, entered ? walk.visit : leaf, entered ? walk.visit_enter : walk.enter);
    walk.next = is_inner(walk.next) ? walk.next : none;
    walk.leaves = false;
    if (!(is_left(walk) && walk.turns > 0u && walk.depth < max_stack)) break;
  }
  turns += walk.turns;
  return !is_left(walk);
}

void main() {
  uint first_place = cluster_place();
  if (first_place >= clusters) return;
  box_tests = node_tests = node_hits = ray_tests = 0u;
  uint turns = max_turns_in_all;
  uint place = first_place;
  for (;;) {
    uint node = first_node + place;
    uvec2 before = uvec2(box_tests, node_tests);
    give_rays(walk_node(node, turns));
    ACCOUNT(tests_object, box_account + node, box_tests - before.x)
    ACCOUNT(tests_node, node_account + node, node_tests - before.y)
    place += clusters;
    if (place >= node_count) break;
  }
  ADD_COUNTER(counter_row + counter_box_tests, box_tests)
  ADD_COUNTER(counter_row + counter_level_tests, node_tests)
  ADD_COUNTER(counter_row + counter_level_hits, node_hits)
  ADD_COUNTER(counter_row + counter_triangle_tests, ray_tests)
}
