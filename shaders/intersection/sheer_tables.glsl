// What hits need to know of triangles with alpha, bound whole as set 1 (C++: scene::GpuScene::sheer_tables, in the same
// order). Texel buffers: kernels that test rays bind as many storage buffers as devices may have already.

#include "shared/limits.h"
#include "shared/scene.h"

layout(set = 1, binding = 0) uniform utextureBuffer sheer_numbers;  // a drawn triangle: of its Sheer
layout(set = 1, binding = 1) uniform utextureBuffer sheers;         // Sheer, three texels each
layout(set = 1, binding = 2) uniform utextureBuffer textures;       // Texture, one
layout(set = 1, binding = 3) uniform utextureBuffer texels0;        // a page each: RGBA8 a word
layout(set = 1, binding = 4) uniform utextureBuffer texels1;
layout(set = 1, binding = 5) uniform utextureBuffer texels2;
layout(set = 1, binding = 6) uniform utextureBuffer texels3;

uint texel_word(uint page, uint index);

Texture texture_of(uint i) {
  uvec4 words = texelFetch(textures, int(i));
  return Texture(words.x, words.y, words.z, words.w);
}

#include "lib/sheer.glsl"

/// Other pages than the first are hardly ever there, and lavapipe reads from all that may be.
uint texel_word(uint page, uint index) {
  int i = int(index);
  if (sheer_pages < 2u || page == 0u) return texelFetch(texels0, i).x;
  if (page == 1u) return texelFetch(texels1, i).x;
  if (page == 2u) return texelFetch(texels2, i).x;
  return texelFetch(texels3, i).x;
}

Sheer sheer_of(uint triangle) {
  int first = int(3u * texelFetch(sheer_numbers, int(triangle)).x);
  return sheer_of_words(texelFetch(sheers, first), texelFetch(sheers, first + 1), texelFetch(sheers, first + 2));
}
