#ifndef CRSH_LIB_TEXTURES_GLSL
#define CRSH_LIB_TEXTURES_GLSL
// A texture sampler of our own: not every device can pick one of many textures by lane. No mip levels: samples smooth.
// The includer defines `uint texel_word(uint page, uint index)`.

#include "shared/limits.h"
#include "shared/scene.h"

const uint wrap_repeat = 0u, wrap_clamp = 1u, wrap_mirror = 2u;

/// The sRGB curve's inverse: coded 0..1 to linear light.
vec3 srgb_to_linear(vec3 coded) {
  vec3 low = coded / 12.92;
  vec3 high = pow((coded + 0.055) / 1.055, vec3(2.4));
  return mix(high, low, lessThanEqual(coded, vec3(0.04045)));
}

/// A texture coordinate brought near 0..1 (mirror: 0..2), so that any float is safe to turn into a texel.
float reduced(float u, uint wrap) {
  if (isnan(u) || isinf(u)) return 0.0;
  if (wrap == wrap_clamp) return clamp(u, 0.0, 1.0);
  return wrap == wrap_repeat ? u - floor(u) : u - 2.0 * floor(u * 0.5);
}

/// A texel's index, which may lie outside by up to the texture's size, brought inside.
int wrapped(int i, int size, uint wrap) {
  if (wrap == wrap_clamp) return clamp(i, 0, size - 1);
  if (wrap == wrap_repeat) return (i + size) % size;
  int twice = (i + 2 * size) % (2 * size);
  return twice < size ? twice : 2 * size - 1 - twice;
}

vec4 texel(Texture image, ivec2 at) {
  int x = wrapped(at.x, int(image.width), image.wrap_s);
  int y = wrapped(at.y, int(image.height), image.wrap_t);
  vec4 value = unpackUnorm4x8(texel_word(image.page, image.first + uint(y) * image.width + uint(x)));
  return image.srgb == 1u ? vec4(srgb_to_linear(value.rgb), value.a) : value;
}

/// The texture at `uv`: nearest or bilinear, each texel decoded before it is filtered.
vec4 sample_texture(Texture image, vec2 uv) {
  vec2 size = vec2(float(image.width), float(image.height));
  vec2 at = vec2(reduced(uv.x, image.wrap_s), reduced(uv.y, image.wrap_t)) * size;
  if (image.nearest == 1u) return texel(image, ivec2(floor(at)));
  vec2 corner = floor(at - 0.5);
  vec2 part = at - 0.5 - corner;
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 4; ++i) {
    ivec2 step = ivec2(i & 1, i >> 1);
    vec2 share = mix(vec2(1.0) - part, part, vec2(step));
    sum += texel(image, ivec2(corner) + step) * (share.x * share.y);
  }
  return sum;
}

#endif
