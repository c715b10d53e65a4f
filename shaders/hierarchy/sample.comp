#version 460
// Counts into how many nodes a sample of a segment's rays would be cut in creation order. That tells how coherent they
// are before they are sorted, which costs time. Lane: a run of rays as in cut.comp; only every `stride`-th run is
// taken.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 16) in;
#include "hierarchy/goes_along.glsl"
#include "lib/invocation.glsl"
#include "shared/limits.h"

layout(push_constant, scalar) uniform Push {
  uint first_ray;  // of the segment
  uint ray_count;
  uint arity;
  uint stride;  // in runs
  uint slot;    // of the segment's sum
  float chord;  // as in cut.comp
  float reach;
};
layout(binding = 0, scalar) readonly buffer Rays { Ray rays[]; };  // in creation order
layout(binding = 1, scalar) buffer Sums { uint sums[]; };

void main() {
  uint i = invocation_index() * stride * cut_run;
  if (i >= ray_count) return;
  uint end = min(i + cut_run, ray_count), head = i, nodes = 1u;
  Ray first = rays[first_ray + i];
  for (;;) {
    if (++i >= end) break;
    Ray ray = rays[first_ray + i];
    bool joins = i - head < arity && goes_along(first, ray, chord, reach);
    if (!joins) {
      first = ray;
      head = i;
      ++nodes;
    }
  }
  atomicAdd(sums[slot], nodes);
}
