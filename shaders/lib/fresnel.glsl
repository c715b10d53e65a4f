#ifndef CRSH_LIB_FRESNEL_GLSL
#define CRSH_LIB_FRESNEL_GLSL
// How much light a surface reflects and how much it lets through: the weights of reflection and refraction rays.

/// A ray whose weight is below this in every channel is not cast.
const float least_weight = 1.0 / 256.0;

/// Reflectance of a dielectric at normal incidence; `ratio` is the ratio of the two indices of refraction, or its
/// inverse.
float dielectric_f0(float ratio) {
  float root = (1.0 - ratio) / (1.0 + ratio);
  return root * root;
}

/// Schlick's weight of grazing incidence, 0 at the normal to 1 at the horizon.
float schlick(float cosine) {
  float across = clamp(1.0 - cosine, 0.0, 1.0);
  float squared = across * across;
  return squared * squared * across;
}

/// Squared cosine of the refracted ray to the normal; negative: total internal reflection.
float refracted_cosine_squared(float cosine, float eta) { return 1.0 - eta * eta * (1.0 - cosine * cosine); }

/// Unpolarised reflectance of a dielectric boundary; eta = n(this side) / n(other side). 1 at total internal
/// reflection.
float dielectric_fresnel(float cosine, float eta) {
  float squared = refracted_cosine_squared(cosine, eta);
  if (squared <= 0.0) return 1.0;
  float beyond = sqrt(squared);
  float across = (eta * cosine - beyond) / (eta * cosine + beyond);
  float along = (cosine - eta * beyond) / (cosine + eta * beyond);
  return clamp(0.5 * (across * across + along * along), 0.0, 1.0);
}

/// How far reflectance at `cosine` has risen, 0 at the normal to 1.
float fresnel_rise(float cosine, float eta) {
  float rise = schlick(cosine);
  if (eta != 1.0) {
    float base = dielectric_f0(eta);
    rise = base < 1.0 ? clamp((dielectric_fresnel(cosine, eta) - base) / (1.0 - base), 0.0, 1.0) : 1.0;
  }
  return rise;
}

/// Reflectance at `cosine`, from f0 up to 1: Schlick's curve where rays do not bend (eta is 1), else the dielectric's
/// exact one, which includes total internal reflection.
vec3 fresnel(vec3 f0, float cosine, float eta) { return f0 + (vec3(1.0) - f0) * fresnel_rise(cosine, eta); }

/// The weight of a reflection ray. A rough surface scatters part of the light; only the rest, the sharp part, is
/// traced.
vec3 reflection_weight(vec3 f0, float cosine, float eta, float roughness) {
  float sharp = 1.0 - roughness;
  return fresnel(f0, cosine, eta) * (sharp * sharp);
}

/// The weight of a refraction ray, 0 at total internal reflection; `diffuse`: base colour less metal.
vec3 refraction_weight(vec3 f0, float cosine, float eta, float transmission, vec3 diffuse) {
  return (vec3(1.0) - fresnel(f0, cosine, eta)) * diffuse * transmission;
}

bool worth_casting(vec3 weight) { return max(max(weight.r, weight.g), weight.b) >= least_weight; }

#endif
