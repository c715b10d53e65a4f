#version 460
// Refraction rays (section 3.2.2): straight on through thin walls, bent by Snell's law at solids, none at total
// internal reflection. They start behind the geometric surface. What passes by a sheet that alphaMode BLEND leaves half
// there goes the same way.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/bsdf.glsl"
#include "rays/closest.glsl"

vec3 refracted(vec3 incoming, float eta, vec3 normal, float cosine) {
  if (eta == 1.0) return incoming;
  precise float beyond = sqrt(max(refracted_cosine_squared(cosine, eta), 0.0));
  precise vec3 direction = incoming * eta + normal * (eta * cosine - beyond);
  return exact_normalize(direction);
}

void main() {
  uint i = invocation_index();
  if (i >= count) return;
  uint surface = first_surface + i;
  vec4 normal = normals[surface], incoming = incomings[surface];
  vec3 behind = -geometrics[surface].xyz;
  float cosine = cosine_of(normal.xyz, incoming.xyz);
  vec3 weight = refraction_weight(speculars[surface].rgb, cosine, incoming.w, normal.w, diffuses[surface].rgb);
  float medium = 0.0;
  if (has_lobes) {
    SurfaceLobes lobes = LOBES_OF(surface);
    weight = lobed_refraction_weight(speculars[surface].rgb, lobes, cosine, incoming.w, normal.w, diffuses[surface].rgb,
                                     -incoming.xyz);
    medium = lobes.medium_behind < 0.0 ? lobes.medium : lobes.medium_behind;
  }
  store(i, weight, 1.0, behind, on_side(refracted(incoming.xyz, incoming.w, normal.xyz, cosine), behind), medium);
}
