#version 460
// Shadow rays (section 3.2.2): from a light to a shaded point, where the light lies in front of the geometric normal
// and reaches the point. They start at the light's end, the paper's inversion, and end just before the surface.
// Lane: a slot, one a surface a light, light-major.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"
#include "lib/lights.glsl"
#include "lib/offset.glsl"
#include "shared/limits.h"
#include "shared/ray.h"

layout(push_constant, scalar) uniform Push {
  uint surfaces;       // slots a segment
  uint first_surface;  // of the batch
  uint first_slot;     // of the first light's segment
  uint count;          // slots: lights times surfaces
  uint first_light;
};
layout(binding = 0, scalar) readonly buffer Positions { vec4 positions[]; };
layout(binding = 1, scalar) readonly buffer Geometrics { vec4 geometrics[]; };
layout(binding = 2, scalar) readonly buffer Lights { Light lights[]; };
layout(binding = 3, scalar) readonly buffer TriangleSpheres { vec4 triangle_spheres[]; };
layout(binding = 4, scalar) writeonly buffer Rays { Ray rays[]; };
layout(binding = 5, scalar) writeonly buffer Flags { uint flags[]; };

/// Whether the light shines on the point's front.
bool lit(Light light, vec3 point, vec3 geometric) {
  Incidence incident = incidence(light, point);
  return incident.share > 0.0 && exact_dot(geometric, incident.towards) > 0.0;
}

Ray shadow_ray(Light light, vec3 point, vec3 geometric, uint triangle) {
  float others = max(extent_of(triangle_spheres[triangle]), largest(light.position.xyz));
  vec3 end = offset_point(point, geometric, others);
  vec3 origin = light_end(light, end);
  precise vec3 way = end - origin;
  bool parallel = uint(light.position.w) == light_directional;
  return Ray(vec4(origin, exact_length(way)),
             vec4(parallel ? light.direction.xyz : exact_normalize(way), float(kind_shadow)));
}

void main() {
  uint i = invocation_index();
  if (i >= count) return;
  uint surface = first_surface + i % surfaces;
  Light light = lights[first_light + i / surfaces];
  vec4 position = positions[surface];
  vec3 geometric = geometrics[surface].xyz;
  uint triangle = floatBitsToUint(position.w);
  bool starts = triangle != none && lit(light, position.xyz, geometric);
  flags[first_slot + i] = uint(starts);
  if (starts) rays[first_slot + i] = shadow_ray(light, position.xyz, geometric, triangle);
}
