// The scene's tables as shaders see them, bound from SCENE_BINDING on in this order (C++: scene::GpuScene).

#include "shared/limits.h"
#include "shared/scene.h"

layout(binding = SCENE_BINDING + 0, scalar) readonly buffer CornersA { vec4 corner_a[]; };
layout(binding = SCENE_BINDING + 1, scalar) readonly buffer CornersB { vec4 corner_b[]; };
layout(binding = SCENE_BINDING + 2, scalar) readonly buffer CornersC { vec4 corner_c[]; };
layout(binding = SCENE_BINDING + 3, scalar) readonly buffer Sources { Source sources[]; };
layout(binding = SCENE_BINDING + 4, scalar) readonly buffer Triangles { uvec4 triangles[]; };
layout(binding = SCENE_BINDING + 5, scalar) readonly buffer Vertices { Vertex vertices[]; };
layout(binding = SCENE_BINDING + 6, scalar) readonly buffer Instances { Instance instances[]; };
layout(binding = SCENE_BINDING + 7, scalar) readonly buffer Materials { Material materials[]; };
layout(binding = SCENE_BINDING + 8, scalar) readonly buffer Textures { uvec4 textures[]; };  // Texture, one load each
layout(binding = SCENE_BINDING + 9, scalar) readonly buffer Texels0 { uint texels0[]; };
layout(binding = SCENE_BINDING + 10, scalar) readonly buffer Texels1 { uint texels1[]; };
layout(binding = SCENE_BINDING + 11, scalar) readonly buffer Texels2 { uint texels2[]; };
layout(binding = SCENE_BINDING + 12, scalar) readonly buffer Texels3 { uint texels3[]; };

uint texel_word(uint page, uint index) {
  if (page == 0u) return texels0[index];
  if (page == 1u) return texels1[index];
  if (page == 2u) return texels2[index];
  return texels3[index];
}

Texture texture_of(uint i) {
  uvec4 words = textures[i];
  return Texture(words.x, words.y, words.z, words.w);
}

uint flags_of(uint triangle) { return floatBitsToUint(corner_a[triangle].w); }

Material material_of(uint triangle) { return materials[flags_of(triangle) & triangle_material_mask]; }
