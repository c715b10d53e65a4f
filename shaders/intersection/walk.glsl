// How one ray walks through the object hierarchy: depth first, the nearer child first, and into no box behind the hit
// so far. It uses bindings 5 to 8 besides those of meet.glsl, whose corners are in leaf order here.
//
// Loops within loops ("while-while", Aila and Laine 2009): first all lanes go down to their next leaves, then all meet
// triangles.

#include "intersection/meet.glsl"
#include "lib/box.glsl"
#include "lib/visit.glsl"

layout(binding = 5, scalar) readonly buffer Rays { Ray rays[]; };  // in creation order
layout(binding = 6, scalar) buffer Counters { uvec2 counters[]; };
layout(binding = 7, scalar) readonly buffer BoxLow { vec4 box_low[]; };
layout(binding = 8, scalar) readonly buffer BoxHigh { vec4 box_high[]; };

/// About how many tests a walk takes in one dispatch. A test is a turn of at most 3 loops. So 16 lanes of a subgroup,
/// even if each takes its turns while the others wait, stay below the 65,535 turns after which lavapipe 22.3 ends loops
/// silently.
const uint max_tests = 1280u;

struct Walk {
  uint next;   // to be visited
  uint depth;  // of the stack
  uvec4 hit;
  uint box_tests;
  uint triangle_tests;
};

/// What is to be visited later, and the t from which on that is of use.
uvec2 stack[max_object_depth];

/// What lies beyond this t cannot change the hit.
float limit_of(Ray ray, uvec4 hit, bool any_hit) {
  return any_hit ? ray.origin.w : min(ray.origin.w, uintBitsToFloat(hit.x));
}

/// Takes the next visit from the stack, and leaves out those that lie behind the hit by now.
void pop(inout Walk walk, float limit) {
  while (walk.next == none && walk.depth > 0u) {
    uvec2 top = stack[--walk.depth];
    walk.next = uintBitsToFloat(top.y) <= limit * box_slack ? top.x : none;
  }
}

/// Goes from a node to the nearer child that the ray may hit; the other one is put on the stack.
void descend(inout Walk walk, BoxRay ray, float limit) {
  uint slot = 2u * walk.next;
  vec4 low0 = box_low[slot], low1 = box_low[slot + 1u], high0 = box_high[slot], high1 = box_high[slot + 1u];
  float enter0, enter1;
  uint visit0 = visit_of(low0.w, high0.w), visit1 = visit_of(low1.w, high1.w);
  bool hit0 = may_hit_box(ray, limit, low0.xyz, high0.xyz, enter0) && visit0 != none;
  bool hit1 = may_hit_box(ray, limit, low1.xyz, high1.xyz, enter1) && visit1 != none;
  bool both = hit0 && hit1, first = hit0 && !(both && enter1 < enter0);
  stack[walk.depth] = uvec2(first ? visit1 : visit0, floatBitsToUint(first ? enter1 : enter0));
  walk.depth += both ? 1u : 0u;
  walk.next = first ? visit0 : hit1 ? visit1 : none;
  walk.box_tests += 2u;
}

void meet_leaf(inout Walk walk, Ray ray, Shear shear) {
  uint count = leaf_triangles(walk.next), begin = leaf_first(walk.next);
  if (count > 0u) {
    uint k = 0u;
    for (;;) {
      walk.hit = meet(walk.hit, ray, shear, load_leaf_triangle(begin + k));
      if (++k >= count) break;
    }
  }
  walk.triangle_tests += count;
  walk.next = is_inner(walk.next) ? walk.next : none;
}

/// Walks on until nothing is left (`next` is `none`), or for about `max_tests`.
void continue_walk(inout Walk walk, Ray ray, bool any_hit) {
  BoxRay box_ray = box_ray(ray.origin.xyz, ray.direction.xyz);
  Shear shear = shear_of(ray.direction.xyz);
  float limit = limit_of(ray, walk.hit, any_hit);
  if (walk.next == none) return;
  for (;;) {
    if (is_inner(walk.next)) {
      for (;;) {
        descend(walk, box_ray, limit);
        pop(walk, limit);
        if (!(is_inner(walk.next) && walk.box_tests < max_tests)) break;
      }
    }
    meet_leaf(walk, ray, shear);
    limit = limit_of(ray, walk.hit, any_hit);
    bool ended = any_hit && all(equal(walk.hit.xyz, uvec3(blocked)));  // no triangle can change that
    walk.depth = ended ? 0u : walk.depth;
    walk.next = ended ? none : walk.next;
    pop(walk, limit);
    if (!(walk.next != none && walk.box_tests + walk.triangle_tests < max_tests)) break;
  }
}
