#ifndef CRSH_LIB_BSDF_GLSL
#define CRSH_LIB_BSDF_GLSL
// glTF's BSDF with all its lobes: from the top a clear coat, sheen, and under them the base, metal or dielectric, with
// a thin film, anisotropy, and diffuse light that goes through. Vectors are unit; `view` points to where the ray came
// from.

#include "lib/brdf.glsl"
#include "lib/iridescence.glsl"
#include "lib/sheen.glsl"
#include "lib/surface_lobes.glsl"

float largest_channel(vec3 colour) { return max(max(colour.r, colour.g), colour.b); }

/// What a surface has without lobes.
struct Base {
  vec3 normal;
  vec3 diffuse;  // base colour less metal and transmission
  vec3 f0;
  float roughness;
};

/// Between F0 and F90 by `rise` (KHR_materials_specular), and the thin film, which rays from inside do not see.
vec3 lobed_reflectance(vec3 f0, SurfaceLobes lobes, float rise, float cosine, bool film) {
  vec3 plain = f0 + (vec3(lobes.f90) - f0) * rise;
  if (!film || lobes.film <= 0.0) return plain;
  return mix(plain, lobes.f90 * film_reflectance(f0, lobes.film_ior, lobes.film_thickness, cosine), lobes.film);
}

/// How much is left for the diffuse part. A coloured dielectric takes from all channels what it reflects most of
/// (KHR_materials_specular, "Implementation"): else what is left would have the complementary colour.
vec3 left_below(vec3 f0, SurfaceLobes lobes, float rise, float cosine, bool film) {
  if (film && lobes.film > 0.0) return vec3(1.0 - largest_channel(lobed_reflectance(f0, lobes, rise, cosine, film)));
  vec3 grey = f0 - lobes.dielectric + largest_channel(lobes.dielectric);
  return vec3(1.0) - (grey + (vec3(lobes.f90) - grey) * rise);
}

/// Widths of the distribution along the tangent and across it (KHR_materials_anisotropy).
vec2 anisotropic_alpha(float roughness, float anisotropy) {
  float used = max(roughness, least_roughness);
  float alpha = used * used;
  return vec2(mix(alpha, 1.0, anisotropy * anisotropy), alpha);
}

/// GGX with two widths, times Smith's masking over 4 cos_light cos_view. `t`, `b`: unit, across the normal.
float anisotropic_lobe(vec3 normal, vec3 t, vec3 view, vec3 light, vec3 middle, vec2 alpha, float cos_light,
                       float cos_view) {
  vec3 b = cross(normal, t);
  float product = alpha.x * alpha.y;
  vec3 f = vec3(alpha.y * dot(t, middle), alpha.x * dot(b, middle), product * clamp(dot(normal, middle), 0.0, 1.0));
  float w = product / max(dot(f, f), 1e-30);
  float masked_light = cos_view * length(vec3(alpha * vec2(dot(t, light), dot(b, light)), cos_light));
  float masked_view = cos_light * length(vec3(alpha * vec2(dot(t, view), dot(b, view)), cos_view));
  return product * w * w / pi * 0.5 / max(masked_light + masked_view, 1e-12);
}

vec3 half_vector(vec3 view, vec3 light) {
  vec3 between = view + light;
  return between * inversesqrt(max(dot(between, between), 1e-12));
}

/// The base, lit from the side of `view`, times the cosine to the light.
vec3 base_light(Base base, SurfaceLobes lobes, vec3 view, vec3 light, float cos_light, float cos_view) {
  vec3 middle = half_vector(view, light);
  float cosine = dot(view, middle), rise = schlick(cosine);
  vec2 alpha = anisotropic_alpha(base.roughness, lobes.anisotropy);
  float lobe = anisotropic_lobe(base.normal, lobes.tangent, view, light, middle, alpha, cos_light, cos_view);
  vec3 left = left_below(base.f0, lobes, rise, cosine, true) * base.diffuse * (1.0 - lobes.through_share);
  return (left / pi + lobed_reflectance(base.f0, lobes, rise, cosine, true) * lobe) * cos_light;
}

/// Light from the other side, times the cosine to it (KHR_materials_diffuse_transmission). What the surface reflects
/// takes its share as if the light stood in front.
vec3 light_through(Base base, SurfaceLobes lobes, vec3 view, vec3 light, float cos_light) {
  vec3 in_front = light + base.normal * (2.0 * cos_light);
  float cosine = dot(view, half_vector(view, in_front));
  return left_below(base.f0, lobes, schlick(cosine), cosine, true) * lobes.through / pi * cos_light;
}

/// What the coat reflects of all light, as seen from `view` (KHR_materials_clearcoat, "Layering").
float coat_reflectance(SurfaceLobes lobes, vec3 view) {
  return lobes.coat * (0.04 + 0.96 * schlick(abs(dot(lobes.coat_normal, view))));
}

/// What the coat adds, times the cosine to the light.
float coat_light(SurfaceLobes lobes, vec3 view, vec3 light) {
  float cos_light = dot(lobes.coat_normal, light);
  if (!(cos_light > 0.0 && lobes.coat > 0.0)) return 0.0;
  float cos_view = max(dot(lobes.coat_normal, view), 1e-4);
  float alpha = max(lobes.coat_roughness, least_roughness);
  alpha *= alpha;
  return coat_reflectance(lobes, view) * ggx_distribution(lobes.coat_normal, half_vector(view, light), alpha) *
         smith_visibility(cos_light, cos_view, alpha) * cos_light;
}

/// What is left of the base under sheen (KHR_materials_sheen, "Albedo-scaling technique").
float left_under_sheen(SurfaceLobes lobes, float cosine) {
  return 1.0 - min(largest_channel(lobes.sheen) * sheen_albedo(cosine, lobes.sheen_roughness), 1.0);
}

vec3 sheen_light(SurfaceLobes lobes, vec3 normal, vec3 view, vec3 light, float cos_light, float cos_view) {
  float alpha = sheen_alpha(lobes.sheen_roughness);
  float cos_middle = clamp(dot(normal, half_vector(view, light)), 0.0, 1.0);
  return lobes.sheen *
         (charlie_distribution(cos_middle, alpha) * sheen_visibility(cos_light, cos_view, alpha) * cos_light);
}

/// The BSDF times the cosine to the light. `behind`: the light stands on the other side of the geometric surface.
vec3 scattered_light(Base base, SurfaceLobes lobes, vec3 view, vec3 light, bool behind) {
  float cos_light = behind ? -dot(base.normal, light) : dot(base.normal, light);
  float coat = coat_reflectance(lobes, view);
  vec3 on_top = behind ? vec3(0.0) : vec3(coat_light(lobes, view, light));
  if (!(cos_light > 0.0)) return on_top;
  float cos_view = max(dot(base.normal, view), 1e-4);
  bool sheen = largest_channel(lobes.sheen) > 0.0;
  vec3 sum = behind ? light_through(base, lobes, view, light, cos_light)
                    : base_light(base, lobes, view, light, cos_light, cos_view);
  if (sheen) sum *= min(left_under_sheen(lobes, cos_view), left_under_sheen(lobes, cos_light));
  if (sheen && !behind) sum += sheen_light(lobes, base.normal, view, light, cos_light, cos_view);
  return sum * (1.0 - coat) + on_top;
}

/// How much of a closest-hit ray's light what lies above the base leaves.
float left_for_base(SurfaceLobes lobes, float cosine, vec3 view) {
  float left = 1.0 - coat_reflectance(lobes, view);
  return largest_channel(lobes.sheen) > 0.0 ? left * left_under_sheen(lobes, cosine) : left;
}

/// `fresnel` with lobes: all of the light is reflected where none can leave, whatever the specular factor.
vec3 lobed_fresnel(vec3 f0, SurfaceLobes lobes, float cosine, float eta) {
  if (eta > 1.0 && refracted_cosine_squared(cosine, eta) <= 0.0) return vec3(1.0);
  return lobed_reflectance(f0, lobes, fresnel_rise(cosine, eta), cosine, eta <= 1.0);
}

/// The weight of the base's reflection ray: only the sharp part is traced, as without lobes.
vec3 base_reflection_weight(vec3 f0, SurfaceLobes lobes, float cosine, float eta, float roughness, vec3 view) {
  float wide = lobes.anisotropy * lobes.anisotropy;
  float mean = sqrt(sqrt(mix(roughness * roughness, 1.0, wide)) * roughness);
  float sharp = 1.0 - (wide > 0.0 ? mean : roughness);
  return lobed_fresnel(f0, lobes, cosine, eta) * (sharp * sharp * left_for_base(lobes, cosine, view));
}

/// And of the coat's.
float coat_reflection_weight(SurfaceLobes lobes, vec3 view) {
  float sharp = 1.0 - lobes.coat_roughness;
  return coat_reflectance(lobes, view) * (sharp * sharp);
}

vec3 lobed_refraction_weight(vec3 f0, SurfaceLobes lobes, float cosine, float eta, float transmission, vec3 diffuse,
                             vec3 view) {
  if (eta > 1.0 && refracted_cosine_squared(cosine, eta) <= 0.0) return vec3(0.0);
  vec3 left = left_below(f0, lobes, fresnel_rise(cosine, eta), cosine, eta <= 1.0);
  return left * diffuse * (transmission * left_for_base(lobes, cosine, view));
}

#endif
