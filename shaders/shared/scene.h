#ifndef CRSH_SHARED_SCENE_H
#define CRSH_SHARED_SCENE_H
#include "shared/types.h"

CRSH_SHARED_BEGIN

// A drawn triangle's corners in world space lie in three buffers of vec4 (a, b, c), counter-clockwise seen from the
// front, also where the instance mirrors. a.w: bits of the flags below and the material; b.w: bits of the instance;
// c.w: bits of the stored triangle's number.
CRSH_CONST uint triangle_cull_back = 1u << 31;     ///< single-sided: eye, reflection and refraction rays pass its back
CRSH_CONST uint triangle_transmissive = 1u << 30;  ///< a shadow ray is tinted, not blocked
CRSH_CONST uint triangle_material_mask = (1u << 30) - 1u;

/// One corner of a stored triangle, object space. 32 bytes.
struct Vertex {
  vec3 normal;  ///< unit; zero where the file has none (flat shading)
  uint colour;  ///< COLOR_0, RGBA8, linear
  vec2 uv0;
  vec2 uv1;
};

/// A drawn triangle's source: which instance, and which triangle of the stored index list.
struct Source {
  uint instance;
  uint triangle;
};

/// Instance: rows of the object-to-world matrix, and of the matrix that turns normals (cofactors). The sphere of
/// objects (section 3.2.1) lies in a buffer of its own.
struct Instance {
  vec4 row0;
  vec4 row1;
  vec4 row2;
  vec4 normal0;  ///< w: 1 where the determinant is negative
  vec4 normal1;
  vec4 normal2;
};

/// A texture as the shader samples it: one word of 16 bytes. Texels are RGBA8 words in up to four buffers (pages).
struct Texture {
  uint first;  ///< index of its first texel in the page
  uint width;
  uint height;
  uint flags;  ///< page (2 bits), wrap_s (2), wrap_t (2): 0 repeat, 1 clamp to edge, 2 mirrored repeat; and:
};
CRSH_CONST uint texture_wrap_s_shift = 2u;
CRSH_CONST uint texture_wrap_t_shift = 4u;
CRSH_CONST uint texture_nearest = 1u << 6;  ///< nearest texel, else bilinear
CRSH_CONST uint texture_srgb = 1u << 7;     ///< RGB is decoded from sRGB before filtering

/// KHR metallic-roughness material with transmission, ior and thickness.
struct Material {
  vec4 base_colour;
  vec4 emissive_metallic;  ///< rgb: emissive factor times strength, cd/m2; w: metallic factor
  vec4 body;       ///< roughness, transmission, ior, thickness (object space metres; 0: thin-walled, does not bend)
  uvec4 textures;  ///< base colour, metallic-roughness, emissive, transmission: index << 1 | texcoord set, or `none`
  uvec4 tint;      ///< xyz: -log2 of what one crossing lets through, 16.16 fixed point, saturated: opaque
};

CRSH_CONST uint light_point = 0u;
CRSH_CONST uint light_spot = 1u;
CRSH_CONST uint light_directional = 2u;

/// A light in world space (KHR_lights_punctual).
struct Light {
  vec4 position;   ///< xyz; w: type
  vec4 direction;  ///< xyz: the way it shines, unit; w: range in metres (infinite: no end)
  vec4 colour;     ///< rgb: colour times candela (point, spot) or lux (directional); w: unused
  vec4 cone;       ///< spot: x = scale, y = offset of the angular attenuation (KHR_lights_punctual)
};

CRSH_SHARED_END
#endif
