#ifndef CRSH_LIB_SURFACE_LOBES_GLSL
#define CRSH_LIB_SURFACE_LOBES_GLSL
// What a point of a surface has beyond the metallic-roughness BRDF (KHR_materials_*): where a scene has any material
// with lobes, these words are kept for every surface; else the kernels compile without them.

#include "shared/scene.h"

layout(constant_id = 20) const bool has_lobes = false;

struct SurfaceLobes {
  float f90;  // reflectance at grazing incidence
  float metallic;
  vec3 dielectric;  // the part of F0 that is no metal's
  float coat;       // clearcoat: how much of the surface it covers
  float coat_roughness;
  vec3 coat_normal;  // unit, on the side of the ray that came
  vec3 sheen;
  float sheen_roughness;
  float film;  // iridescence: how much of the surface the thin film covers
  float film_ior;
  float film_thickness;  // nanometres
  vec3 tangent;          // unit, at right angles to the shading normal; along it roughness is larger
  float anisotropy;
  vec3 through;         // base colour of light from the other side, less metal and transmission
  float through_share;  // of diffuse light
  bool unlit;
  float medium;         // number, from 1 on, of the Lobes whose solid the ray that came has travelled in; 0: none
  float medium_behind;  // the same behind the surface; negative: the same solid
};

/// The words of surface i begin at this one.
uint first_lobe_word(uint i) { return i * surface_lobe_words; }

vec4[surface_lobe_words] packed_lobes(SurfaceLobes l) {
  return vec4[surface_lobe_words](vec4(l.f90, l.metallic, l.coat, l.coat_roughness),
                                  vec4(l.coat_normal, l.unlit ? 1.0 : 0.0), vec4(l.sheen, l.sheen_roughness),
                                  vec4(l.film, l.film_ior, l.film_thickness, l.medium), vec4(l.tangent, l.anisotropy),
                                  vec4(l.through, l.through_share), vec4(l.dielectric, l.medium_behind));
}

const uint lobe_word_of_medium = 3u;

SurfaceLobes unpacked_lobes(vec4 w[surface_lobe_words]) {
  SurfaceLobes l;
  l.f90 = w[0].x;
  l.metallic = w[0].y;
  l.coat = w[0].z;
  l.coat_roughness = w[0].w;
  l.coat_normal = w[1].xyz;
  l.unlit = w[1].w != 0.0;
  l.sheen = w[2].rgb;
  l.sheen_roughness = w[2].w;
  l.film = w[3].x;
  l.film_ior = w[3].y;
  l.film_thickness = w[3].z;
  l.medium = w[3].w;
  l.tangent = w[4].xyz;
  l.anisotropy = w[4].w;
  l.through = w[5].rgb;
  l.through_share = w[5].w;
  l.dielectric = w[6].rgb;
  l.medium_behind = w[6].w;
  return l;
}

/// The includer binds `surface_lobes` and says so by a macro of this name.
#define LOBES_OF(i)                                                                                            \
  unpacked_lobes(                                                                                              \
      vec4[surface_lobe_words](surface_lobes[first_lobe_word(i)], surface_lobes[first_lobe_word(i) + 1u],      \
                               surface_lobes[first_lobe_word(i) + 2u], surface_lobes[first_lobe_word(i) + 3u], \
                               surface_lobes[first_lobe_word(i) + 4u], surface_lobes[first_lobe_word(i) + 5u], \
                               surface_lobes[first_lobe_word(i) + 6u]))

/// Any unit vector at right angles to a unit vector.
vec3 perpendicular(vec3 normal) {
  vec3 axis = abs(normal.x) < 0.6 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
  return normalize(cross(normal, axis));
}

/// Of a surface that has none.
SurfaceLobes no_lobes(vec3 normal, float f0_share, float metallic) {
  return SurfaceLobes(1.0, metallic, vec3(f0_share), 0.0, 0.0, normal, vec3(0.0), 1.0, 0.0, 1.3, 0.0,
                      perpendicular(normal), 0.0, vec3(0.0), 0.0, false, 0.0, -1.0);
}

#endif
