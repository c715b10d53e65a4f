#ifndef CRSH_LIB_BRDF_GLSL
#define CRSH_LIB_BRDF_GLSL
// glTF 2.0's metallic-roughness BRDF (appendix B of its specification) for light from one direction.

#include "lib/fresnel.glsl"

/// The least roughness that is used: a smoother surface would show a lamp, which has no extent, as infinitely bright or
/// not at all.
const float least_roughness = 0.045;
const float pi = 3.14159265358979;

/// GGX (Trowbridge-Reitz) distribution of microfacets. The squared sine to the half vector is taken from a cross
/// product, because 1 - cos^2 loses all its digits in the middle of a sharp highlight.
float ggx_distribution(vec3 normal, vec3 middle, float alpha) {
  float squared = alpha * alpha;
  float cosine = clamp(dot(normal, middle), 0.0, 1.0);
  vec3 across = cross(normal, middle);
  float fall = cosine * cosine * squared + dot(across, across);
  return squared / (pi * max(fall * fall, 1e-30));
}

/// Smith's height-correlated masking and shadowing, over 4 cos_light cos_view.
float smith_visibility(float cos_light, float cos_view, float alpha) {
  float squared = alpha * alpha;
  float light = cos_view * sqrt(cos_light * cos_light * (1.0 - squared) + squared);
  float view = cos_light * sqrt(cos_view * cos_view * (1.0 - squared) + squared);
  return 0.5 / max(light + view, 1e-12);
}

/// The BRDF times the cosine to the light. Vectors are unit; `view` points to where the ray came from. `diffuse`: base
/// colour less metal and transmission.
vec3 reflected_light(vec3 normal, vec3 view, vec3 light, vec3 diffuse, vec3 f0, float roughness) {
  float cos_light = dot(normal, light);
  if (!(cos_light > 0.0)) return vec3(0.0);
  float cos_view = max(dot(normal, view), 1e-4);
  vec3 between = view + light;
  vec3 middle = between * inversesqrt(max(dot(between, between), 1e-12));
  float alpha = max(roughness, least_roughness);
  alpha *= alpha;
  vec3 mirrored = f0 + (vec3(1.0) - f0) * schlick(dot(view, middle));
  float lobe = ggx_distribution(normal, middle, alpha) * smith_visibility(cos_light, cos_view, alpha);
  return ((vec3(1.0) - mirrored) * diffuse / pi + mirrored * lobe) * cos_light;
}

#endif
