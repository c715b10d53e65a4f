#version 460
// What each surface of a generation sends back along the ray that came: its own light, and what its reflection and
// refraction rays brought, which are surfaces of the next generation. Lane: a surface.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"
#include "shared/limits.h"

/// Where the children of one kind are: its slot of surface `first_surface`, the ray that became the children's
/// surface 0 (modulo 2^32), and whether there are any.
struct Link {
  uint first_slot;
  uint first_ray;
  uint any;
};
layout(constant_id = 0) const bool parts = false;  // wanted: for layers
layout(push_constant, scalar) uniform Push {
  uint first_surface;
  uint count;
  Link reflection;
  Link refraction;
  vec3 background;  // of the generation: what a ray that met nothing brings
};
layout(binding = 0, scalar) readonly buffer Emissions { vec4 emissions[]; };
layout(binding = 1, scalar) readonly buffer Direct { vec4 direct[]; };
layout(binding = 2, scalar) readonly buffer ReflectionWeights { vec4 reflection_weights[]; };
layout(binding = 3, scalar) readonly buffer RefractionWeights { vec4 refraction_weights[]; };
layout(binding = 4, scalar) readonly buffer ReflectionEnds { uint reflection_ends[]; };
layout(binding = 5, scalar) readonly buffer RefractionEnds { uint refraction_ends[]; };
layout(binding = 6, scalar) readonly buffer ReflectionTotals { vec4 reflection_totals[]; };
layout(binding = 7, scalar) readonly buffer RefractionTotals { vec4 refraction_totals[]; };
layout(binding = 8, scalar) writeonly buffer Totals { vec4 totals[]; };        // w: 1 where something was met
layout(binding = 9, scalar) writeonly buffer Reflected { vec4 reflected[]; };  // the parts, where wanted
layout(binding = 10, scalar) writeonly buffer Refracted { vec4 refracted[]; };

/// The ray in the slot between these ends, as child; `none` where the slot is empty.
uint child_between(uint before, uint end, Link link) { return end > before ? before - link.first_ray : none; }

uint reflection_child(uint i) {
  if (reflection.any == 0u) return none;
  uint slot = reflection.first_slot + i;
  return child_between(slot == 0u ? 0u : reflection_ends[slot - 1u], reflection_ends[slot], reflection);
}

uint refraction_child(uint i) {
  if (refraction.any == 0u) return none;
  uint slot = refraction.first_slot + i;
  return child_between(slot == 0u ? 0u : refraction_ends[slot - 1u], refraction_ends[slot], refraction);
}

void main() {
  uint i = invocation_index();
  if (i >= count) return;
  uint surface = first_surface + i;
  uint mirrored = reflection_child(i), bent = refraction_child(i);
  vec3 from_reflection = vec3(0.0), from_refraction = vec3(0.0);
  if (mirrored != none) from_reflection = reflection_weights[surface].rgb * reflection_totals[mirrored].rgb;
  if (bent != none) from_refraction = refraction_weights[surface].rgb * refraction_totals[bent].rgb;
  vec4 emission = emissions[surface];
  bool met = emission.w >= 0.0;
  vec3 own = emission.rgb + direct[surface].rgb + from_reflection + from_refraction;
  totals[surface] = met ? vec4(own, 1.0) : vec4(background, 0.0);
  if (!parts) return;
  reflected[surface] = vec4(from_reflection, 0.0);
  refracted[surface] = vec4(from_refraction, 0.0);
}
