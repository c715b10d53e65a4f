#version 460
// The raster pass (section 3.1), fragments: position, normal, diffuse and specular properties of what the eye sees,
// four floats a pixel each, and the triangle, from which later stages derive what else they need.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "lib/exact.glsl"
#include "raster/view.glsl"
#include "scene/surface.glsl"
#define VARYING in
#include "raster/varyings.glsl"

layout(location = 0) out vec4 out_position;  // w: roughness
layout(location = 1) out vec4 out_normal;    // shading normal, on the eye's side; w: transmission
layout(location = 2) out vec4 out_diffuse;   // base colour less metal; w: metallic
layout(location = 3) out vec4 out_specular;  // F0; w: how much of it is there (alphaMode BLEND)
layout(location = 4) out uint out_triangle;  // its number from 1 on; 0: nothing

/// Barycentric weights cost three loads; only tangents need them.
Point point_of(Material material) {
  Point point = Point(drawn_triangle, position, vec3(0.0), front, area, cone_at(position));
  if ((material.slots & 1u << slot_normal) == 0u) return point;
  Corners at = corners_at(drawn_triangle);
  point.weights = weights_at(position, at.a, at.b, at.c);
  return point;
}

/// Leaves out what alpha cuts away, and returns how much of the rest is there.
float coverage() {
  if (sheer_pages == 0u || (flags_of(drawn_triangle) & triangle_sheer) == 0u) return 1.0;
  Corners at = corners_at(drawn_triangle);
  float alpha = coverage_at(drawn_triangle, weights_at(position, at.a, at.b, at.c));
  if (alpha < 0.0) discard;
  return alpha;
}

void main() {
  float alpha = coverage();
  Attributes at = Attributes(normal, colour, vec2[3](texcoords.xy, texcoords.zw, more_texcoords));
  Material material = material_of(drawn_triangle);
  Surface seen = surface_of(material, at, point_of(material), eye_ray(position));
  out_position = vec4(seen.position, seen.roughness);
  out_normal = vec4(seen.normal, seen.transmission);
  out_diffuse = vec4(seen.diffuse, seen.metallic);
  out_specular = vec4(seen.specular, alpha);
  out_triangle = drawn_triangle + 1u;
}
