// The scene's tables, bound whole as set 1 (C++: scene::GpuScene::tables, in the same order). All but the instances are
// texel buffers: as storage buffers they would be more than many devices can bind. They are read as integers, because
// a device may flush tiny floats to zero, and flags and numbers look like these.

#include "shared/limits.h"
#include "shared/scene.h"

layout(set = 1, binding = 0) uniform utextureBuffer corner_a;  // of a drawn triangle: bits of a vec4 (shared/scene.h)
layout(set = 1, binding = 1) uniform utextureBuffer corner_b;
layout(set = 1, binding = 2) uniform utextureBuffer corner_c;
layout(set = 1, binding = 3) uniform utextureBuffer triangles;  // StoredTriangle, two texels each
layout(set = 1, binding = 4) uniform utextureBuffer vertices;   // Vertex, three
layout(set = 1, binding = 5, scalar) readonly buffer Instances { Instance instances[]; };
layout(set = 1, binding = 6) uniform utextureBuffer materials;     // Material, six
layout(set = 1, binding = 7) uniform utextureBuffer textures;      // Texture, one
layout(set = 1, binding = 8) uniform utextureBuffer texture_uses;  // TextureUse, two
layout(set = 1, binding = 9) uniform utextureBuffer lobes;         // Lobes, eight
layout(set = 1, binding = 10) uniform utextureBuffer texels0;      // a page each: RGBA8 a word
layout(set = 1, binding = 11) uniform utextureBuffer texels1;
layout(set = 1, binding = 12) uniform utextureBuffer texels2;
layout(set = 1, binding = 13) uniform utextureBuffer texels3;
layout(set = 1, binding = 14) uniform utextureBuffer sheers;  // Sheer, three

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

StoredTriangle stored_triangle(uint stored) {
  uvec4 first = texelFetch(triangles, int(2u * stored)), second = texelFetch(triangles, int(2u * stored + 1u));
  return StoredTriangle(first.xyz, first.w, second.xyz, second.w);
}

Vertex vertex_at(uint i) {
  uvec4 a = texelFetch(vertices, int(3u * i)), b = texelFetch(vertices, int(3u * i + 1u)),
        c = texelFetch(vertices, int(3u * i + 2u));
  return Vertex(uintBitsToFloat(a.xyz), a.w, b.xy,
                vec2[3](uintBitsToFloat(b.zw), uintBitsToFloat(c.xy), uintBitsToFloat(c.zw)));
}

vec4 material_word(uint material, uint word) {
  return uintBitsToFloat(texelFetch(materials, int(6u * material + word)));
}

Material material_at(uint i) {
  uvec4 links = texelFetch(materials, int(6u * i + 4u));
  return Material(material_word(i, 0u), material_word(i, 1u), material_word(i, 2u), material_word(i, 3u), links.x,
                  links.y, links.z, links.w, texelFetch(materials, int(6u * i + 5u)));
}

Material material_of(uint triangle) { return material_at(flags_of(triangle) & triangle_material_mask); }

TextureUse texture_use(uint i) {
  uvec4 a = texelFetch(texture_uses, int(2u * i)), b = texelFetch(texture_uses, int(2u * i + 1u));
  return TextureUse(a.x, a.y, uintBitsToFloat(uvec4(a.zw, b.xy)), uintBitsToFloat(b.zw));
}

vec4 lobe_word(uint i, uint word) { return uintBitsToFloat(texelFetch(lobes, int(8u * i + word))); }

Lobes lobes_at(uint i) {
  return Lobes(lobe_word(i, 0u), lobe_word(i, 1u), lobe_word(i, 2u), lobe_word(i, 3u), lobe_word(i, 4u),
               lobe_word(i, 5u), lobe_word(i, 6u), lobe_word(i, 7u));
}
