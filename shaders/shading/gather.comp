#version 460
// Adds to what each surface sends back what its ray of one closest-hit kind brought: the total of the surface that the
// ray met, one of the next generation. Lane: a surface of a batch.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"

layout(constant_id = 0) const bool apart = false;  // kept apart besides, for a layer
layout(push_constant, scalar) uniform Push {
  uint first_surface;  // of the batch
  uint count;
  uint first_slot;  // of surface `first_surface`
  uint first_ray;   // that became surface 0 of the next generation, modulo 2^32
};
layout(binding = 0, scalar) readonly buffer Weights { vec4 weights[]; };
layout(binding = 1, scalar) readonly buffer Ends { uint ends[]; };
layout(binding = 2, scalar) readonly buffer ChildTotals { vec4 child_totals[]; };
layout(binding = 3, scalar) buffer Totals { vec4 totals[]; };
// What this kind brought, where wanted; else 0.
layout(binding = 4, scalar) writeonly buffer Brought { vec4 brought[]; };

void main() {
  uint i = invocation_index();
  if (i >= count) return;
  uint surface = first_surface + i, slot = first_slot + i;
  uint ray = slot == 0u ? 0u : ends[slot - 1u];
  if (ends[slot] == ray) return;  // no ray in this slot
  vec4 weight = weights[surface], child = child_totals[ray - first_ray];
  precise vec3 light = weight.rgb * child.rgb;
  totals[surface] += vec4(light, fract(weight.w) * (child.w - 1.0));  // nothing met beside the surface: not covered
  if (apart) brought[surface] = vec4(light, 0.0);
}
