// One ray through the object hierarchy: depth first, the nearer child first, and no box behind the hit so far. Bindings
// 5 to 8 are taken besides those of meet.glsl, whose corners are those in leaf order here.
//
// Loops within loops ("while-while", Aila and Laine 2009): lanes go down to their next leaves together, then meet
// triangles together.

#include "intersection/meet.glsl"
#include "lib/box.glsl"
#include "shared/object.h"

layout(binding = 5, scalar) readonly buffer Rays { Ray rays[]; };  // in creation order
layout(binding = 6, scalar) buffer Counters { uvec2 counters[]; };
layout(binding = 7, scalar) readonly buffer BoxLow { vec4 box_low[]; };
layout(binding = 8, scalar) readonly buffer BoxHigh { vec4 box_high[]; };

// What is to be visited, in one word: an inner node's index; or a leaf, the number of its triangles less 1, and the
// first of them; or `none`.
const uint leaf_count_shift = 29u;
const uint leaf_first_mask = (1u << leaf_count_shift) - 1u;

/// Tests of a walk in one dispatch, about. A test is a turn of 3 loops at most; 16 lanes, each of them alone, come to
/// less than the 65,535 turns after which lavapipe 22.3 ends loops silently.
const uint most_tests = 1280u;

struct Walk {
  uint next;   // to be visited
  uint depth;  // of the stack
  uvec4 hit;
  uint box_tests;
  uint triangle_tests;
};

/// What is to be visited later, and from which t on.
uvec2 stack[max_object_depth];

/// A leaf with the bits of its number of triangles; a node as it is.
uint visit_of(uint ref, uint count) {
  return (ref & child_is_leaf) != 0u ? ref | (count - 1u) << leaf_count_shift : ref;
}

/// Beyond this t nothing counts.
float limit_of(Ray ray, uvec4 hit, bool shadow) {
  return shadow ? ray.origin.w : min(ray.origin.w, uintBitsToFloat(hit.x));
}

/// Goes on with what was left for later, unless a hit is nearer by now.
void pop(inout Walk walk, float limit) {
  while (walk.next == none && walk.depth > 0u) {
    uvec2 top = stack[--walk.depth];
    walk.next = uintBitsToFloat(top.y) <= limit * box_slack ? top.x : none;
  }
}

/// From a node to its nearer child that the ray may hit; the other one is left for later.
void descend(inout Walk walk, BoxRay ray, float limit) {
  uint slot = 2u * walk.next;
  vec4 low0 = box_low[slot], low1 = box_low[slot + 1u], high0 = box_high[slot], high1 = box_high[slot + 1u];
  float enter0, enter1;
  uint count0 = floatBitsToUint(high0.w), count1 = floatBitsToUint(high1.w);
  bool hit0 = may_hit_box(ray, limit, low0.xyz, high0.xyz, enter0) && count0 != 0u;
  bool hit1 = may_hit_box(ray, limit, low1.xyz, high1.xyz, enter1) && count1 != 0u;
  uint visit0 = visit_of(floatBitsToUint(low0.w), count0), visit1 = visit_of(floatBitsToUint(low1.w), count1);
  bool both = hit0 && hit1, first = hit0 && !(both && enter1 < enter0);
  stack[walk.depth] = uvec2(first ? visit1 : visit0, floatBitsToUint(first ? enter1 : enter0));
  walk.depth += both ? 1u : 0u;
  walk.next = first ? visit0 : hit1 ? visit1 : none;
  walk.box_tests += 2u;
}

Loaded load_leaf_triangle(uint place) {
  vec4 c = corner_c[place];
  return Loaded(floatBitsToUint(c.w), corner_a[place], corner_b[place], c);
}

void meet_leaf(inout Walk walk, Ray ray) {
  bool leaf = walk.next != none && (walk.next & child_is_leaf) != 0u;
  uint count = leaf ? (walk.next >> leaf_count_shift & 3u) + 1u : 0u, begin = walk.next & leaf_first_mask;
  for (uint k = 0u; k < count; ++k) walk.hit = meet(walk.hit, ray, load_leaf_triangle(begin + k));
  walk.triangle_tests += count;
  walk.next = leaf ? none : walk.next;
}

bool is_node(uint visit) { return (visit & child_is_leaf) == 0u; }

/// Walks on until nothing is left (`next` is `none`), or for about `most_tests`.
void walk_on(inout Walk walk, Ray ray, bool shadow) {
  BoxRay box_ray = box_ray(ray.origin.xyz, ray.direction.xyz);
  float limit = limit_of(ray, walk.hit, shadow);
  while (walk.next != none && walk.box_tests + walk.triangle_tests < most_tests) {
    while (is_node(walk.next) && walk.box_tests < most_tests) {
      descend(walk, box_ray, limit);
      pop(walk, limit);
    }
    meet_leaf(walk, ray);
    limit = limit_of(ray, walk.hit, shadow);
    bool ended = shadow && all(equal(walk.hit.xyz, uvec3(blocked)));  // no triangle can change that
    walk.depth = ended ? 0u : walk.depth;
    walk.next = ended ? none : walk.next;
    pop(walk, limit);
  }
}
