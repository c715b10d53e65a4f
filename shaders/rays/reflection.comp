#version 460
// Reflection rays (section 3.2.2): mirrored about the shading normal, kept in front of the geometric surface.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
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
  if (mirror == 1u) weight = vec3(1.0);
  store(i, weight, geometric.xyz, mirrored(incoming.xyz, normal.xyz, geometric.xyz));
}
