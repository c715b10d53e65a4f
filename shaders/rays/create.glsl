// What every ray kind's creation shader begins with: what it may know, and where its rays go. Lane: a slot, one a
// surface a segment, segment-major. What is cast by chance takes its numbers from lib/chance.glsl, by pixel, path,
// sample and seed.

layout(local_size_x = 64) in;
#include "lib/exact.glsl"
#include "lib/invocation.glsl"
#include "lib/offset.glsl"
#include "lib/surface_lobes.glsl"
#include "shared/limits.h"
#include "shared/ray.h"
#include "shared/scene.h"

layout(push_constant, scalar) uniform Push {
  uint surfaces;       // slots a segment
  uint first_surface;  // of the batch
  uint first_slot;     // of the kind's first segment
  uint count;          // slots of all its segments
  uint kind;
  uint first_light;   // of the first segment, where there is one a light
  uint mirror;        // 1: the kind makes mirrors of all surfaces (--override-mirror)
  uint sample_index;  // of the frame, from 0
  uint seed;          // --seed
  float scene_edge;   // longest edge of the scene's bounds, metres
};
layout(binding = 0, scalar) readonly buffer Positions { vec4 positions[]; };
layout(binding = 1, scalar) readonly buffer Normals { vec4 normals[]; };
layout(binding = 2, scalar) readonly buffer Geometrics { vec4 geometrics[]; };
layout(binding = 3, scalar) readonly buffer Incomings { vec4 incomings[]; };
layout(binding = 4, scalar) readonly buffer Diffuses { vec4 diffuses[]; };    // w: pixel
layout(binding = 5, scalar) readonly buffer Speculars { vec4 speculars[]; };  // w: path
layout(binding = 6, scalar) readonly buffer Lights { Light lights[]; };
layout(binding = 7, scalar) readonly buffer TriangleSpheres { vec4 triangle_spheres[]; };
layout(binding = 8, scalar) writeonly buffer Rays { Ray rays[]; };
layout(binding = 9, scalar) writeonly buffer Flags { uint flags[]; };

layout(binding = 10, scalar) readonly buffer SurfaceLobesIn { vec4 surface_lobes[]; };  // where has_lobes

bool met_nothing(uint surface) { return floatBitsToUint(positions[surface].w) == none; }

/// Bound of the coordinates of the triangle that the surface lies on.
float extent_at(uint surface) { return extent_of(triangle_spheres[floatBitsToUint(positions[surface].w)]); }

/// The slot's ray; `passes`: past_backs or 0.
void store_ray(uint i, vec3 origin, vec3 direction, float end, float passes) {
  flags[first_slot + i] = 1u;
  rays[first_slot + i] = Ray(vec4(origin, end), vec4(direction, float(kind) + passes));
}

void store_ray(uint i, vec3 origin, vec3 direction, float end) { store_ray(i, origin, direction, end, 0.0); }

/// No ray starts in the slot.
void store_none(uint i) { flags[first_slot + i] = 0u; }
