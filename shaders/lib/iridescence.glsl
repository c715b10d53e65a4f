#ifndef CRSH_LIB_IRIDESCENCE_GLSL
#define CRSH_LIB_IRIDESCENCE_GLSL
// Reflectance of a thin film on a base (KHR_materials_iridescence, after Belcour and Barla, "A Practical Extension to
// Microfacet Theory for the Modeling of Varying Iridescence", 2017).

#include "lib/fresnel.glsl"

vec3 squared(vec3 v) { return v * v; }

/// Index of refraction of what reflects so much at normal incidence, seen from air.
vec3 ior_of_f0(vec3 f0) {
  vec3 root = sqrt(clamp(f0, 0.0, 0.9999));
  return (1.0 + root) / (1.0 - root);
}

/// How the eye's three colours, as Rec. 709, take light whose two ways differ by `difference` (metres) and `shift`
/// (radians): Gaussians fitted to CIE's XYZ curves.
vec3 film_sensitivity(float difference, vec3 shift) {
  const float pi2 = 6.28318530717959;
  const vec3 value = vec3(5.4856e-13, 4.4201e-13, 5.2481e-13);
  const vec3 place = vec3(1.6810e+06, 1.7953e+06, 2.2084e+06);
  const vec3 variance = vec3(4.3278e+09, 9.3046e+09, 6.6121e+09);
  float phase = pi2 * difference;
  vec3 xyz = value * sqrt(pi2 * variance) * cos(place * phase + shift) * exp(-phase * phase * variance);
  xyz.x += 9.7470e-14 * sqrt(pi2 * 4.5282e+09) * cos(2.2399e+06 * phase + shift.x) * exp(-4.5282e+09 * phase * phase);
  xyz /= 1.0685e-7;
  return mat3(3.2404542, -0.9692660, 0.0556434, -1.5371385, 1.8760108, -0.2040259, -0.4985314, 0.0415560, 1.0572252) *
         xyz;
}

vec3 schlick_from(vec3 f0, float cosine) { return f0 + (1.0 - f0) * schlick(cosine); }

/// `thickness` in nanometres; `cosine` to the half vector, in air. A film of no thickness is none.
vec3 film_reflectance(vec3 base_f0, float film_ior, float thickness, float cosine) {
  float ior = mix(1.0, film_ior, smoothstep(0.0, 0.03, thickness));
  float inside = refracted_cosine_squared(cosine, 1.0 / ior);
  if (inside < 0.0) return vec3(1.0);
  float beyond = sqrt(inside);
  float first = dielectric_f0(ior);
  first += (1.0 - first) * (ior == 1.0 ? 0.0 : schlick(cosine));  // reflected where light enters the film
  vec3 base_ior = ior_of_f0(base_f0);
  vec3 second = schlick_from(squared((base_ior - ior) / (base_ior + ior)), beyond);  // and where it meets the base
  const float pi1 = 3.14159265358979;
  vec3 shift = pi1 + mix(vec3(0.0), vec3(pi1), lessThan(base_ior, vec3(ior)));
  float passes = (1.0 - first) * (1.0 - first);
  vec3 both = min(first * second, vec3(0.9999));
  vec3 root = sqrt(both), series = passes * second / (1.0 - both);
  vec3 sum = first + series, term = series - (1.0 - first);
  float difference = 2.0 * ior * thickness * 1e-9 * beyond;
  for (int m = 1; m <= 2; ++m) {
    term *= root;
    sum += term * 2.0 * film_sensitivity(float(m) * difference, float(m) * shift);
  }
  return clamp(sum, 0.0, 1.0);
}

#endif
