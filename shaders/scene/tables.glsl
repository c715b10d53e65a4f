// The scene's tables, bound whole as set 1 (C++: scene::GpuScene::tables, in the same order). Corners, textures and
// texels are texel buffers: as storage buffers they would be more than many devices can bind. They are read as
// integers, because a device may flush tiny floats to zero, and flags and numbers look like these.

#include "shared/limits.h"
#include "shared/scene.h"

layout(set = 1, binding = 0) uniform utextureBuffer corner_a;  // of a drawn triangle: bits of a vec4 (shared/scene.h)
layout(set = 1, binding = 1) uniform utextureBuffer corner_b;
layout(set = 1, binding = 2) uniform utextureBuffer corner_c;
layout(set = 1, binding = 3, scalar) readonly buffer Triangles { uvec4 triangles[]; };  // as stored
layout(set = 1, binding = 4, scalar) readonly buffer Vertices { Vertex vertices[]; };
layout(set = 1, binding = 5, scalar) readonly buffer Instances { Instance instances[]; };
layout(set = 1, binding = 6, scalar) readonly buffer Materials { Material materials[]; };
layout(set = 1, binding = 7) uniform utextureBuffer textures;  // Texture, a texel each
layout(set = 1, binding = 8) uniform utextureBuffer texels0;   // a page each: RGBA8 a word
layout(set = 1, binding = 9) uniform utextureBuffer texels1;
layout(set = 1, binding = 10) uniform utextureBuffer texels2;
layout(set = 1, binding = 11) uniform utextureBuffer texels3;

uint texel_word(uint page, uint index) {
  int i = int(index);
  if (page == 0u) return texelFetch(texels0, i).x;
  if (page == 1u) return texelFetch(texels1, i).x;
  if (page == 2u) return texelFetch(texels2, i).x;
  return texelFetch(texels3, i).x;
}

Texture texture_of(uint i) {
  uvec4 words = texelFetch(textures, int(i));
  return Texture(words.x, words.y, words.z, words.w);
}

/// A drawn triangle's corners in world space.
struct Corners {
  vec3 a;
  vec3 b;
  vec3 c;
};

Corners corners_at(uint triangle) {
  int i = int(triangle);
  return Corners(uintBitsToFloat(texelFetch(corner_a, i).xyz), uintBitsToFloat(texelFetch(corner_b, i).xyz),
                 uintBitsToFloat(texelFetch(corner_c, i).xyz));
}

uint flags_of(uint triangle) { return texelFetch(corner_a, int(triangle)).w; }

uint instance_of(uint triangle) { return texelFetch(corner_b, int(triangle)).w; }

/// The stored triangle that a drawn one is an instance of.
uint stored_of(uint triangle) { return texelFetch(corner_c, int(triangle)).w; }

Material material_of(uint triangle) { return materials[flags_of(triangle) & triangle_material_mask]; }
