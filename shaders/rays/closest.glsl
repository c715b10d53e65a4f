// What the creation of reflection and refraction rays shares: they start at a surface, take the closest hit, and leave
// their weight to the gathering. Lane: a slot, one a surface.

layout(local_size_x = 64) in;
#include "lib/fresnel.glsl"
#include "lib/invocation.glsl"
#include "lib/offset.glsl"
#include "shared/limits.h"
#include "shared/ray.h"

layout(push_constant, scalar) uniform Push {
  uint surfaces;       // slots of the segment
  uint first_surface;  // of the batch
  uint first_slot;     // of the segment
  uint mirror;         // 1: every surface reflects all besides (--override-mirror)
};
layout(binding = 0, scalar) readonly buffer Positions { vec4 positions[]; };
layout(binding = 1, scalar) readonly buffer Normals { vec4 normals[]; };
layout(binding = 2, scalar) readonly buffer Geometrics { vec4 geometrics[]; };
layout(binding = 3, scalar) readonly buffer Incomings { vec4 incomings[]; };
layout(binding = 4, scalar) readonly buffer Diffuses { vec4 diffuses[]; };
layout(binding = 5, scalar) readonly buffer Speculars { vec4 speculars[]; };
layout(binding = 6, scalar) readonly buffer TriangleSpheres { vec4 triangle_spheres[]; };
layout(binding = 7, scalar) writeonly buffer Rays { Ray rays[]; };
layout(binding = 8, scalar) writeonly buffer Flags { uint flags[]; };
layout(binding = 9, scalar) writeonly buffer Weights { vec4 weights[]; };

bool met_nothing(uint surface) { return floatBitsToUint(positions[surface].w) == none; }

/// Cosine between the shading normal and the way back along the ray that came.
float cosine_of(vec3 normal, vec3 incoming) { return clamp(-exact_dot(normal, incoming), 0.0, 1.0); }

/// Writes the surface's weight, and its ray to the side that `side` points to where that is worth casting.
void store(uint i, vec3 weight, vec3 side, vec3 direction, uint kind) {
  uint surface = first_surface + i;
  bool starts = worth_casting(weight) && !met_nothing(surface);
  weights[surface] = vec4(starts ? weight : vec3(0.0), 0.0);
  flags[first_slot + i] = uint(starts);
  if (!starts) return;
  vec4 position = positions[surface];
  vec3 origin = offset_point(position.xyz, side, extent_of(triangle_spheres[floatBitsToUint(position.w)]));
  rays[first_slot + i] = Ray(vec4(origin, uintBitsToFloat(0x7F800000u)), vec4(direction, float(kind)));
}
