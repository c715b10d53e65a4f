#version 460
// Where cut nodes begin (--nodes cut). A lane walks a run of children of one segment. It begins a new node where the
// one before is full, where the octant of directions changes, and where direction or origin is too far from that of the
// node's first ray. These are the head flags of section 3.2.3, for nodes instead of chunks. A child that is a node is
// judged by its first ray.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 16) in;
#include "hierarchy/goes_along.glsl"
#include "lib/invocation.glsl"
#include "shared/limits.h"

layout(push_constant, scalar) uniform Push {
  uint first_child;  // of the segment
  uint children;
  uint arity;
  uint rays_below;  // 1: children are rays themselves (level 1)
  float chord;      // on the unit sphere: greatest distance from the direction of the node's first ray
  float reach;      // greatest distance from that ray's origin, metres
};
layout(binding = 0, scalar) readonly buffer Rays { Ray rays[]; };                  // in sorted order
layout(binding = 1, scalar) readonly buffer RaysBelow { uvec2 rays_of_child[]; };  // level 1: not read
layout(binding = 2, scalar) writeonly buffer Heads { uint heads[]; };              // 1: a node begins at this child
layout(binding = 3, scalar) writeonly buffer Ends { uint ends[]; };  // where the node that begins here ends

void main() {
  uint begin = invocation_index() * cut_run;
  if (begin >= children) return;
  uint end = min(begin + cut_run, children);
  Ray first = Ray(vec4(0.0), vec4(0.0));
  uint head = begin;
  uint i = begin;
  for (;;) {
    uint child = first_child + i;
    uint position = child;
    if (rays_below == 0u) position = rays_of_child[child].x;
    Ray ray = rays[position];
    bool joins = i > begin && i - head < arity && goes_along(first, ray, chord, reach);
    heads[child] = joins ? 0u : 1u;
    if (!joins) {
      if (i > begin) ends[first_child + head] = child;
      first = ray;
      head = i;
    }
    if (++i >= end) break;
  }
  ends[first_child + head] = first_child + end;
}
