#ifndef CRSH_LIB_SHEEN_GLSL
#define CRSH_LIB_SHEEN_GLSL
// The sheen of cloth (KHR_materials_sheen, after Estevez and Kulla, "Production Friendly Microfacet Sheen BRDF", 2017).

/// A smaller sheen roughness would make the rim thinner than any pixel.
const float least_sheen_roughness = 0.07;

float sheen_alpha(float roughness) {
  float used = max(roughness, least_sheen_roughness);
  return used * used;
}

/// "Charlie": the inverted Gaussian distribution of microfacets.
float charlie_distribution(float cos_middle, float alpha) {
  float sine_squared = max(1.0 - cos_middle * cos_middle, 0.0);
  return (2.0 + 1.0 / alpha) * pow(sine_squared, 0.5 / alpha) / 6.28318530717959;
}

float sheen_curve(float x, float alpha) {
  float rest = (1.0 - alpha) * (1.0 - alpha);
  float a = mix(21.5473, 25.3245, rest), b = mix(3.82987, 3.32435, rest), c = mix(0.19823, 0.16801, rest);
  float d = mix(-1.97760, -1.27393, rest), e = mix(-4.32054, -4.85967, rest);
  return a / (1.0 + b * pow(x, c)) + d * x + e;
}

float sheen_lambda(float cosine, float alpha) {
  if (cosine < 0.5) return exp(sheen_curve(cosine, alpha));
  return exp(2.0 * sheen_curve(0.5, alpha) - sheen_curve(max(1.0 - cosine, 0.0), alpha));
}

/// Masking and shadowing over 4 cos_light cos_view.
float sheen_visibility(float cos_light, float cos_view, float alpha) {
  float both = 1.0 + sheen_lambda(cos_view, alpha) + sheen_lambda(cos_light, alpha);
  return 1.0 / max(both * 4.0 * cos_light * cos_view, 1e-12);
}

/// The directional albedo of white sheen, "E" in the extension: 16 by 16 values of 8 bits, by roughness, then the root
/// of the cosine, both from 0 to 1. They are integrals over the two functions above, 1 at most.
const uint sheen_albedos[64] =
    uint[64](0xFFFFFFFFu, 0x0A2156B8u, 0x00000002u, 0x00000000u, 0xFFFFFFFFu, 0x0A2156B8u, 0x00000002u, 0x00000000u,
             0xFFFFFFFFu, 0x2C4E80C0u, 0x01030916u, 0x00000000u, 0xE1FFFFFFu, 0x415F84B0u, 0x060D192Au, 0x00000102u,
             0xC7E9FBD4u, 0x4C6683A4u, 0x0E182537u, 0x00010307u, 0xBAD3DFBAu, 0x546A839Eu, 0x17223041u, 0x0103080Eu,
             0xB4C9D2ADu, 0x5B6F859Cu, 0x1F2B3949u, 0x02070D15u, 0xB3C6CDA8u, 0x6275899Eu, 0x27344251u, 0x050C131Cu,
             0xB7C8CDA7u, 0x6A7C8EA2u, 0x2F3C4A59u, 0x09111A24u, 0xBDCED1ABu, 0x728395A9u, 0x37445262u, 0x0E17212Bu,
             0xC4D5D8B1u, 0x7A8B9DB1u, 0x3E4C5A6Au, 0x131D2732u, 0xCCDDE0B8u, 0x8193A5B9u, 0x45536271u, 0x18232D39u,
             0xD4E5E8C0u, 0x8899ACC0u, 0x4B596878u, 0x1E28333Fu, 0xDAEBEEC6u, 0x8D9FB1C5u, 0x505E6D7Du, 0x222D3844u,
             0xDCEEF1C9u, 0x90A1B4C8u, 0x54627080u, 0x26313C47u, 0xDAEBEEC7u, 0x90A1B3C6u, 0x56637280u, 0x2A343E4Au);

float sheen_albedo_at(uint roughness, uint cosine) {
  uint i = roughness * 16u + cosine;
  return float(sheen_albedos[i >> 2] >> 8u * (i & 3u) & 255u) / 255.0;
}

float sheen_albedo(float cosine, float roughness) {
  vec2 place = vec2(sqrt(clamp(cosine, 0.0, 1.0)), clamp(roughness, 0.0, 1.0)) * 15.0;
  vec2 corner = min(floor(place), vec2(14.0)), part = place - corner;
  uint c = uint(corner.x), r = uint(corner.y);
  return mix(mix(sheen_albedo_at(r, c), sheen_albedo_at(r, c + 1u), part.x),
             mix(sheen_albedo_at(r + 1u, c), sheen_albedo_at(r + 1u, c + 1u), part.x), part.y);
}

#endif
