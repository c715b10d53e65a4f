#ifndef CRSH_LIB_TEXTURES_GLSL
#define CRSH_LIB_TEXTURES_GLSL
// A texture sampler of our own, because not every device can choose another texture in each lane. The includer defines
// `uint texel_word(uint page, uint index)` and `Texture texture_of(uint i)`.

#include "shared/limits.h"
#include "shared/scene.h"

const uint wrap_repeat = 0u, wrap_clamp = 1u, wrap_mirror = 2u;

uint wrap_of(Texture image, uint shift) { return image.flags >> shift & 3u; }

/// Linear light of a value in sRGB, 0 to 1.
vec3 srgb_to_linear(vec3 coded) {
  vec3 low = coded / 12.92;
  vec3 high = pow((coded + 0.055) / 1.055, vec3(2.4));
  return mix(high, low, lessThanEqual(coded, vec3(0.04045)));
}

/// A texture coordinate brought near 0..1 (mirrored: 0..2), so that any float can safely become an index.
float reduced(float u, uint wrap) {
  if (isnan(u) || isinf(u)) return 0.0;
  if (wrap == wrap_clamp) return clamp(u, 0.0, 1.0);
  return wrap == wrap_repeat ? u - floor(u) : u - 2.0 * floor(u * 0.5);
}

/// The index of a texel, or of its neighbour, wrapped into the texture. Without a division, which lavapipe does lane by
/// lane.
int wrapped(int i, int size, uint wrap) {
  if (wrap == wrap_clamp) return clamp(i, 0, size - 1);
  int period = wrap == wrap_repeat ? size : 2 * size;
  int inside = i < 0 ? i + period : i >= period ? i - period : i;
  return inside < size ? inside : 2 * size - 1 - inside;
}

vec4 texel(Texture image, ivec2 at) {
  int x = wrapped(at.x, int(image.width), wrap_of(image, texture_wrap_s_shift));
  int y = wrapped(at.y, int(image.height), wrap_of(image, texture_wrap_t_shift));
  vec4 value = unpackUnorm4x8(texel_word(image.flags & 3u, image.first + uint(y) * image.width + uint(x)));
  return (image.flags & texture_srgb) != 0u ? vec4(srgb_to_linear(value.rgb), value.a) : value;
}

/// One level of a texture at `uv`: nearest or bilinear, each texel decoded before it is filtered.
vec4 sample_level(Texture image, bool nearest, vec2 uv) {
  vec2 size = vec2(float(image.width), float(image.height));
  vec2 at =
      vec2(reduced(uv.x, wrap_of(image, texture_wrap_s_shift)), reduced(uv.y, wrap_of(image, texture_wrap_t_shift))) *
      size;
  vec2 corner = floor(nearest ? at : at - 0.5);
  vec2 part = nearest ? vec2(0.0) : at - 0.5 - corner;
  vec4 sum = vec4(0.0);
  for (int i = 0; i < (nearest ? 1 : 4); ++i) {
    ivec2 step = ivec2(i & 1, i >> 1);
    vec2 share = mix(vec2(1.0) - part, part, vec2(step));
    sum += texel(image, ivec2(corner) + step) * (share.x * share.y);
  }
  return sum;
}

/// How many times smaller than the texture a level has to be that is seen with these texels a footprint, as a power of
/// two: `texels`, of level 0, that the footprint is wide.
float level_of(float texels) { return texels > 1.0 ? log2(texels) : 0.0; }

/// Texture `index`, of which `whole` is the largest level, at `uv`, seen with a footprint that is `texels` of that
/// level wide (up to 1: magnified; glTF 2.0, section 3.8.4).
vec4 sample_texture(Texture whole, uint index, vec2 uv, float texels) {
  uint last = whole.flags >> texture_levels_shift & 15u;
  if (texels <= 1.0 || last == 0u) {
    uint way = texels <= 1.0 ? texture_nearest : texture_nearest_in_level;
    return sample_level(whole, (whole.flags & way) != 0u, uv);
  }
  float level = min(level_of(texels), float(last));
  bool one = (whole.flags & texture_nearest_level) != 0u;
  float first = one ? floor(level + 0.5) : floor(level);
  float part = one ? 0.0 : level - first;
  bool nearest = (whole.flags & texture_nearest_in_level) != 0u;
  vec4 sum = vec4(0.0);
  for (uint i = 0u; i < (part > 0.0 ? 2u : 1u); ++i)
    sum += sample_level(texture_of(index + uint(first) + i), nearest, uv) * (i == 0u ? 1.0 - part : part);
  return sum;
}

#endif
