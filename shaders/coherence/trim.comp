#version 460
// Array trimming (section 3.2.2, Figure 4): copies the rays that exist, without the empty slots between them, to the
// places that the inclusive scan of the head flags gives, and writes from which slot each came.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/invocation.glsl"
#include "shared/ray.h"

layout(local_size_x = 64) in;
layout(scalar, binding = 0) readonly buffer Sparse { Ray sparse[]; };
layout(scalar, binding = 1) readonly buffer Flags { uint flags[]; };
layout(scalar, binding = 2) readonly buffer Ends { uint ends[]; };
layout(scalar, binding = 3) writeonly buffer Rays { Ray rays[]; };
layout(scalar, binding = 4) writeonly buffer Slots { uint slots[]; };
layout(scalar, push_constant) uniform Push { uint slot_count; };

void main() {
  const uint slot = invocation_index();
  if (slot >= slot_count || flags[slot] == 0) return;
  const uint ray = ends[slot] - 1;
  rays[ray] = sparse[slot];
  slots[ray] = slot;
}
