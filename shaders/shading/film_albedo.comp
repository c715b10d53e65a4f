#version 460
// Adds the base colour of each surface of a sample to its pixel. Lane: a surface.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"

#include "lib/surface_lobes.glsl"

layout(push_constant, scalar) uniform Push { uint count; };
layout(binding = 0, scalar) readonly buffer Diffuses { vec4 diffuses[]; };
layout(binding = 1, scalar) readonly buffer Speculars { vec4 speculars[]; };
layout(binding = 2, scalar) readonly buffer Emissions { vec4 emissions[]; };
layout(binding = 3, scalar) buffer Albedo { vec4 albedo[]; };

layout(binding = 4, scalar) readonly buffer SurfaceLobesIn { vec4 surface_lobes[]; };  // where has_lobes

void main() {
  uint i = invocation_index();
  if (i >= count) return;
  vec4 diffuse = diffuses[i];
  vec4 emission = emissions[i];
  if (emission.w < 0.0) return;   // nothing was met
  vec3 share = vec3(emission.w);  // the part of F0 that is not base colour
  if (has_lobes) {
    SurfaceLobes lobes = LOBES_OF(i);
    share = lobes.dielectric;
    if (lobes.unlit) diffuse.rgb += emission.rgb;
  }
  albedo[floatBitsToUint(diffuse.w)] += vec4(diffuse.rgb + speculars[i].rgb - share, 0.0);
}
