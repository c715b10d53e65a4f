#version 460
// Reflection rays (section 3.2.2): mirrored about the shading normal, kept in front of the geometric surface. Under a
// clear coat one ray stands for both reflections: about the normal of the one that weighs more.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/bsdf.glsl"
#include "rays/closest.glsl"

vec3 mirrored(vec3 incoming, vec3 normal, vec3 geometric) {
  precise vec3 direction = incoming - normal * (2.0 * exact_dot(normal, incoming));
  return on_side(exact_normalize(direction), geometric);
}

void main() {
  uint i = invocation_index();
  if (i >= count) return;
  uint surface = first_surface + i;
  vec4 normal = normals[surface], geometric = geometrics[surface], incoming = incomings[surface];
  vec3 weight = reflection_weight(speculars[surface].rgb, cosine_of(normal.xyz, incoming.xyz), incoming.w, geometric.w);
  float medium = 0.0;
  if (has_lobes) {
    SurfaceLobes lobes = LOBES_OF(surface);
    weight = base_reflection_weight(speculars[surface].rgb, lobes, cosine_of(normal.xyz, incoming.xyz), incoming.w,
                                    geometric.w, -incoming.xyz);
    float coat = coat_reflection_weight(lobes, -incoming.xyz);
    if (coat > largest_channel(weight) && mirror == 0u) normal.xyz = lobes.coat_normal;
    weight += coat;
    medium = lobes.medium;
  }
  if (mirror == 1u) weight = vec3(1.0);
  store(i, weight, geometric.xyz, mirrored(incoming.xyz, normal.xyz, geometric.xyz), medium);
}
