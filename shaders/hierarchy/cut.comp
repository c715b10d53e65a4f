#version 460
// Where nodes begin when they are cut (--nodes cut): where their coherence ends. A lane walks a run of children of one
// segment and begins a node where the last one is full, and where the direction's octant or the angle to the node's
// first ray changes too much. These are the head flags of section 3.2.3 for nodes instead of chunks.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 16) in;
#include "lib/invocation.glsl"
#include "shared/limits.h"
#include "shared/ray.h"

layout(push_constant, scalar) uniform Push {
  uint first_child;  // of the segment
  uint children;
  uint arity;
  uint rays_below;   // 1: children are rays themselves (level 1)
  float chord;       // of the largest angle to the node's first ray
};
layout(binding = 0, scalar) readonly buffer Rays { Ray rays[]; };                // in sorted order
layout(binding = 1, scalar) readonly buffer RaysBelow { uvec2 rays_of_child[]; };  // level 1: not read
layout(binding = 2, scalar) writeonly buffer Heads { uint heads[]; };            // 1: a node begins at this child
layout(binding = 3, scalar) writeonly buffer Ends { uint ends[]; };              // where the node that begins here ends

bool goes_along(vec3 first, vec3 direction) {
  bvec3 same_side = equal(lessThan(first, vec3(0.0)), lessThan(direction, vec3(0.0)));
  precise vec3 apart = direction - first;
  precise float squared = (apart.x * apart.x + apart.y * apart.y) + apart.z * apart.z;
  return all(same_side) && squared <= chord * chord;
}

void main() {
  uint begin = invocation_index() * cut_run;
  if (begin >= children) return;
  uint end = min(begin + cut_run, children);
  vec3 first = vec3(0.0);
  uint head = begin;
  for (uint i = begin; i < end; ++i) {
    uint child = first_child + i;
    vec3 direction = rays[rays_below == 1u ? child : rays_of_child[child].x].direction.xyz;
    bool joins = i > begin && i - head < arity && goes_along(first, direction);
    heads[child] = joins ? 0u : 1u;
    first = joins ? first : direction;
    head = joins ? head : i;
    ends[first_child + head] = child + 1u;
  }
}
