#ifndef CRSH_LIB_SURFACE_GLSL
#define CRSH_LIB_SURFACE_GLSL
// What a surface is where a ray meets a triangle. The raster pass and the hits of rays use the same functions.

#include "lib/exact.glsl"
#include "lib/fresnel.glsl"
#include "shared/scene.h"

/// The paper's position, normal, diffuse and specular (section 3.1), and what reflection and refraction need.
struct Surface {
  vec3 position;
  vec3 normal;     // shading normal, unit, on the side of the ray that came
  vec3 geometric;  // unit, turned to the ray that came
  vec3 diffuse;    // base colour less metal, before transmission takes its share
  float metallic;
  vec3 specular;  // F0
  float roughness;
  float transmission;
  float eta;      // n(this side) / n(other side); 1 where the ray does not bend
  vec3 emission;  // cd/m2
  float alpha;    // coverage: 1, but where alphaMode is BLEND
};

/// Unit normal of the front; 0 for a triangle without area. Edges are scaled first, so that small triangles do not
/// underflow.
vec3 front_normal(vec3 a, vec3 b, vec3 c) {
  precise vec3 ab = b - a;
  precise vec3 ac = c - a;
  float scale = max(largest(ab), largest(ac));
  if (!(scale > 0.0)) return vec3(0.0);
  precise vec3 left = ab / scale;
  precise vec3 right = ac / scale;
  return exact_normalize(exact_cross(left, right));
}

/// Whether a ray along `incoming` meets the front.
bool meets_front(vec3 front, vec3 incoming) { return exact_dot(front, incoming) <= 0.0; }

/// The front's normal turned to the ray that came; against the ray where the triangle has no area.
vec3 turned_normal(vec3 front, vec3 incoming) {
  if (exact_dot(front, front) == 0.0) return -incoming;
  return meets_front(front, incoming) ? front : -front;
}

/// A normal that points away from the ray that came, as it may at the silhouette of a coarse mesh, turned until it does
/// not.
vec3 lifted_normal(vec3 normal, vec3 incoming) {
  precise float away = exact_dot(normal, incoming) + 1e-3;
  precise vec3 lifted = normal - incoming * away;
  return away > 0.0 ? exact_normalize(lifted) : normal;
}

/// The interpolated normal, turned to the geometric normal's side and to the ray that came. Zero: the geometric normal,
/// for flat shading.
vec3 shading_normal(vec3 interpolated, vec3 geometric, vec3 incoming) {
  vec3 normal = exact_normalize(interpolated);
  if (!(exact_dot(normal, normal) > 0.5)) return geometric;
  if (exact_dot(normal, geometric) < 0.0) normal = -normal;
  return lifted_normal(normal, incoming);
}

/// The frame in which normal maps tilt, as MikkTSpace has it: neither normal nor tangent are unit or at right angles
/// after interpolation. `sign`: the bitangent's.
struct TangentFrame {
  vec3 tangent;
  vec3 bitangent;
  vec3 normal;
};

TangentFrame tangent_frame(vec3 normal, vec3 tangent, float sign) {
  return TangentFrame(tangent, cross(normal, tangent) * sign, normal);
}

/// The normal that a normal map's texel stands for (glTF 2.0, section 3.9.3), on the side of the front.
vec3 mapped_normal(TangentFrame frame, vec3 texel, float scale) {
  vec3 tilt = (texel * 2.0 - 1.0) * vec3(scale, scale, 1.0);
  return frame.tangent * tilt.x + frame.bitangent * tilt.y + frame.normal * tilt.z;
}

/// Barycentric weights, none negative, of a point on the triangle (a third each where it has no area).
vec3 weights_at(vec3 point, vec3 a, vec3 b, vec3 c) {
  vec3 front = front_normal(a, b, c);
  precise vec3 pa = a - point;
  precise vec3 pb = b - point;
  precise vec3 pc = c - point;
  vec3 areas = vec3(exact_dot(exact_cross(pb, pc), front), exact_dot(exact_cross(pc, pa), front),
                    exact_dot(exact_cross(pa, pb), front));
  areas = max(areas, vec3(0.0));
  precise float sum = (areas.x + areas.y) + areas.z;
  precise vec3 weights = sum > 0.0 ? areas / sum : vec3(1.0 / 3.0);
  return weights;
}

/// The point with these weights.
vec3 point_at(vec3 weights, vec3 a, vec3 b, vec3 c) {
  precise vec3 point = (a * weights.x + b * weights.y) + c * weights.z;
  return point;
}

/// Whether rays bend, as in a solid and not in a thin wall (KHR_materials_volume).
bool bends(Material material) {
  float transmission = material.body.y, ior = material.body.z, thickness = material.body.w;
  return thickness > 0.0 && transmission > 0.0 && ior > 0.0;
}

float eta_of(Material material, bool front) {
  if (!bends(material)) return 1.0;
  return front ? 1.0 / material.body.z : material.body.z;
}

/// F0 of the part that is not metal.
float dielectric_share(Material material, float metallic) { return dielectric_f0(material.body.z) * (1.0 - metallic); }

#endif
