#version 460
// Direct light (section 3.2.6, then glTF's BSDF): adds up, for each light of a batch in order, what its shadow ray lets
// through times what the surface reflects to the eye. Lane: a surface.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/bsdf.glsl"
#include "lib/invocation.glsl"
#include "lib/lights.glsl"
#include "shared/ray.h"

layout(push_constant, scalar) uniform Push {
  uint surfaces;       // slots a segment
  uint first_surface;  // of the batch
  uint first_slot;     // of the first light's segment
  uint first_light;
  uint light_count;  // of this batch: at most 64 segments
};
layout(binding = 0, scalar) readonly buffer Positions { vec4 positions[]; };
layout(binding = 1, scalar) readonly buffer Normals { vec4 normals[]; };
layout(binding = 2, scalar) readonly buffer Geometrics { vec4 geometrics[]; };
layout(binding = 3, scalar) readonly buffer Incomings { vec4 incomings[]; };
layout(binding = 4, scalar) readonly buffer Diffuses { vec4 diffuses[]; };
layout(binding = 5, scalar) readonly buffer Speculars { vec4 speculars[]; };
layout(binding = 6, scalar) readonly buffer Lights { Light lights[]; };
layout(binding = 7, scalar) readonly buffer Ends { uint ends[]; };
layout(binding = 8, scalar) readonly buffer Hits { Hit hits[]; };
layout(binding = 9, scalar) buffer Direct { vec4 direct[]; };
layout(binding = 10, scalar) readonly buffer SurfaceLobesIn { vec4 surface_lobes[]; };  // where has_lobes
layout(binding = 11, scalar) readonly buffer Footprints { vec2 footprints[]; };  // y: how much of the surface is there
#include "shading/shadow_hits.glsl"

vec3 light_from(uint surface, Light light, vec3 visibility) {
  Incidence incident = incidence(light, positions[surface].xyz);
  vec4 normal = normals[surface];
  vec3 scattered = diffuses[surface].rgb * (1.0 - normal.w);
  if (has_lobes) {
    vec4 geometric = geometrics[surface];
    Base base = Base(normal.xyz, scattered, speculars[surface].rgb, geometric.w);
    bool behind = dot(geometric.xyz, incident.towards) < 0.0;
    return footprints[surface].y * light.colour.rgb * incident.share * visibility *
           scattered_light(base, LOBES_OF(surface), -incomings[surface].xyz, incident.towards, behind);
  }
  return footprints[surface].y * light.colour.rgb * incident.share * visibility *
         reflected_light(normal.xyz, -incomings[surface].xyz, incident.towards, scattered, speculars[surface].rgb,
                         geometrics[surface].w);
}

void main() {
  uint i = invocation_index();
  if (i >= surfaces) return;
  uint surface = first_surface + i;
  vec4 sum = direct[surface];
  uint l = 0u;
  for (;;) {
    uint ray = ray_of(first_slot + l * surfaces + i);
    if (ray != none) sum.rgb += light_from(surface, lights[first_light + l], let_through(hits[ray].words.xyz));
    if (++l >= light_count) break;
  }
  direct[surface] = sum;
}
