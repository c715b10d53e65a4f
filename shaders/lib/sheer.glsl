#ifndef CRSH_LIB_SHEER_GLSL
#define CRSH_LIB_SHEER_GLSL
// How much of a triangle is there at a point (alphaMode MASK and BLEND): its coverage, from base colour texture, factor
// and vertex colour. Eye, shadow and closest-hit rays ask this one function, and get the same answer: it takes the
// texture at its largest level, as seen large, because a shadow ray has no footprint. All of it is `precise`, so that
// every kernel finds the same hits bit for bit. The includer defines `uint texel_word(uint page, uint index)` and
// `Texture texture_of(uint i)`.

#include "lib/textures.glsl"

/// Of how many pages of texels triangles with alpha use textures; 0: no triangle of the scene has alpha, and what asks
/// for it is compiled out.
layout(constant_id = 19) const uint sheer_pages = 0u;

/// BLEND: less than this is not there at all, so that no ray ends at a texel that is cut away.
const float least_alpha = 1.0 / 256.0;

/// Alpha of a texel, 0 to 255.
float texel_alpha(Texture image, int x, int y) {
  uint column = uint(wrapped(x, int(image.width), wrap_of(image, texture_wrap_s_shift)));
  uint row = uint(wrapped(y, int(image.height), wrap_of(image, texture_wrap_t_shift)));
  return float(texel_word(image.flags & 3u, image.first + row * image.width + column) >> 24);
}

/// Alpha of a texture's largest level, 0 to 1, filtered as where it is seen large.
float texture_alpha(uint index, vec2 uv) {
  Texture image = texture_of(index);
  bool nearest = (image.flags & texture_nearest) != 0u;
  vec2 inside =
      vec2(reduced(uv.x, wrap_of(image, texture_wrap_s_shift)), reduced(uv.y, wrap_of(image, texture_wrap_t_shift)));
  precise vec2 at = inside * vec2(float(image.width), float(image.height));
  precise vec2 from_centres = nearest ? at : at - vec2(0.5);
  vec2 corner = floor(from_centres);
  precise vec2 part = nearest ? vec2(0.0) : from_centres - corner;
  int x = int(corner.x), y = int(corner.y);
  vec4 texels = vec4(texel_alpha(image, x, y), texel_alpha(image, x + 1, y), texel_alpha(image, x, y + 1),
                     texel_alpha(image, x + 1, y + 1));
  // A value plus a share of a difference: between equal texels it is exactly theirs.
  precise vec2 rows = texels.xz + (texels.yw - texels.xz) * part.x;
  precise float alpha = (rows.x + (rows.y - rows.x) * part.y) / 255.0;
  return alpha;
}

/// Coverage at a point with these barycentric weights. `mirrored`: its corners b and c are the stored c and b.
float alpha_at(Sheer sheer, vec3 weights, bool mirrored) {
  vec2 share = mirrored ? weights.zy : weights.yz;
  precise float alpha =
      (sheer.alpha.x + (sheer.alpha.y - sheer.alpha.x) * share.x) + (sheer.alpha.z - sheer.alpha.x) * share.y;
  if (sheer.texture != none) {
    precise vec2 uv = (sheer.uv[0] + (sheer.uv[1] - sheer.uv[0]) * share.x) + (sheer.uv[2] - sheer.uv[0]) * share.y;
    precise float both = alpha * texture_alpha(sheer.texture, uv);
    alpha = both;
  }
  return clamp(alpha, 0.0, 1.0);
}

bool is_blended(Sheer sheer) { return sheer.cutoff < 0.0; }

/// Whether a ray meets the triangle where its coverage is `alpha`.
bool is_there(Sheer sheer, float alpha) { return alpha >= (is_blended(sheer) ? least_alpha : sheer.cutoff); }

/// A Sheer of its three texels.
Sheer sheer_of_words(uvec4 a, uvec4 b, uvec4 c) {
  return Sheer(vec2[3](uintBitsToFloat(a.xy), uintBitsToFloat(a.zw), uintBitsToFloat(b.xy)),
               uintBitsToFloat(uvec3(b.zw, c.x)), uintBitsToFloat(c.y), c.z, c.w);
}

#endif
