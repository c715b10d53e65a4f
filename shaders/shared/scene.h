#ifndef CRSH_SHARED_SCENE_H
#define CRSH_SHARED_SCENE_H
#include "shared/types.h"

CRSH_SHARED_BEGIN

// A drawn triangle's corners in world space lie in three buffers of vec4 (a, b, c), counter-clockwise seen from the
// front, also where the instance mirrors. a.w: bits of the flags below and the material; b.w: bits of the instance;
// c.w: bits of the stored triangle's number.
CRSH_CONST uint triangle_cull_back = 1u << 31;     ///< single-sided: eye, reflection and refraction rays pass its back
CRSH_CONST uint triangle_transmissive = 1u << 30;  ///< a shadow ray is tinted, not blocked
CRSH_CONST uint triangle_sheer = 1u << 29;         ///< its alpha decides what of it is there (alphaMode MASK and BLEND)
CRSH_CONST uint triangle_mirrored = 1u << 28;      ///< its instance mirrors: corners b and c are the stored c and b
CRSH_CONST uint triangle_material_mask = (1u << 28) - 1u;

/// A stored triangle.
struct StoredTriangle {
  uvec3 vertices;
  uint material;  ///< and the flags above but triangle_mirrored
  /// How texture coordinates run over the triangle, a word a set of them, by which textures are filtered: the matrix
  /// J transposed(J) times the triangle's doubled area, J being their derivative by position. It has no unit, and so
  /// stays what it is where the triangle is scaled. Bits, from the lowest: three numbers of 8 bits (dudu, dudv + 128,
  /// dvdv) and their exponent (scene::packed_metric).
  uvec3 uv_metrics;
  uint sheer;  ///< number of its Sheer record, where triangle_sheer is set
};

/// How much of a stored triangle is there (alphaMode MASK and BLEND), of its corners as they are stored.
struct Sheer {
  vec2 uv[3];    ///< of the base colour's texture, after its transform
  vec3 alpha;    ///< of the vertices' colours, times the material's factor
  float cutoff;  ///< MASK: what is less is not there; negative: BLEND
  uint texture;  ///< number of the texture; none: alpha is the corners' alone
  uint through;  ///< BLEND: what the part that is there lets through to a shadow ray: RGB, 10 bits each
};

/// One corner of a stored triangle, object space.
struct Vertex {
  vec3 normal;   ///< unit; zero where the file has none (flat shading)
  uint tangent;  ///< as packed_tangent (lib/tangent.glsl); 0: none
  uvec2 colour;  ///< COLOR_0, RGBA, linear, four halves
  vec2 uv[3];
};

// What deforms (glTF 2.0, sections 3.7.2.2 and 3.7.3). Each instance that does has stored vertices and triangles of its
// own, behind those of the meshes that do not.

/// A vertex at rest. Its lists end where the next vertex's begin; one more ends the last.
struct RestVertex {
  vec3 position;
  uint first_influence;
  vec3 normal;
  uint first_displacement;
  uint tangent;  ///< as packed_tangent
};

/// How much a joint moves a vertex.
struct Influence {
  uint joint;  ///< of the skin; `none`: the last one
  float weight;
};

/// What a morph target of weight 1 adds.
struct Displacement {
  vec3 position;
  uint target;
  vec3 normal;
  vec3 tangent;
};

/// A vertex of an instance that deforms.
struct PosedVertex {
  uint rest;   ///< its RestVertex
  uint posed;  ///< its instance's PosedInstance
};

/// An instance that deforms.
struct PosedInstance {
  uint first_joint;   ///< of its skin
  uint joint_count;   ///< 0: it has no skin
  uint first_weight;  ///< of its morph targets
  uint instance;
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

/// A texture as the shader samples it: one word of 16 bytes. Texels are RGBA8 words in up to four buffers (pages). The
/// smaller levels of a texture, each half the size of the one before, are the next textures of the table.
struct Texture {
  uint first;  ///< index of its first texel in the page
  uint width;
  uint height;
  uint flags;  ///< page (2 bits), wrap_s (2), wrap_t (2): 0 repeat, 1 clamp to edge, 2 mirrored repeat; and:
};
CRSH_CONST uint texture_wrap_s_shift = 2u;
CRSH_CONST uint texture_wrap_t_shift = 4u;
CRSH_CONST uint texture_nearest = 1u << 6;           ///< seen large: nearest texel, else bilinear
CRSH_CONST uint texture_srgb = 1u << 7;              ///< RGB is decoded from sRGB before filtering
CRSH_CONST uint texture_nearest_in_level = 1u << 8;  ///< seen small: nearest texel of a level
CRSH_CONST uint texture_nearest_level = 1u << 9;     ///< seen small: the nearest level, else two are mixed
CRSH_CONST uint texture_levels_shift = 12u;          ///< how many levels there are below this one (4 bits)

/// Where a material uses a texture: which, with which coordinates (KHR_texture_transform).
struct TextureUse {
  uint texture;
  uint uv_set;
  vec4 matrix;  ///< rows of what the coordinates are multiplied by
  vec2 offset;  ///< and what is added then
};

// What a material may have textures for: bits of Material::slots, whose texture uses follow one another in this order.
// C++: scene::Slot.
CRSH_CONST uint slot_base_colour = 0u;
CRSH_CONST uint slot_metallic_roughness = 1u;
CRSH_CONST uint slot_emissive = 2u;
CRSH_CONST uint slot_transmission = 3u;
CRSH_CONST uint slot_normal = 4u;
CRSH_CONST uint slot_occlusion = 5u;
CRSH_CONST uint slot_specular = 6u;
CRSH_CONST uint slot_specular_colour = 7u;
CRSH_CONST uint slot_clearcoat = 8u;
CRSH_CONST uint slot_clearcoat_roughness = 9u;
CRSH_CONST uint slot_clearcoat_normal = 10u;
CRSH_CONST uint slot_sheen_colour = 11u;
CRSH_CONST uint slot_sheen_roughness = 12u;
CRSH_CONST uint slot_iridescence = 13u;
CRSH_CONST uint slot_iridescence_thickness = 14u;
CRSH_CONST uint slot_anisotropy = 15u;
CRSH_CONST uint slot_thickness = 16u;
CRSH_CONST uint slot_diffuse_transmission = 17u;
CRSH_CONST uint slot_diffuse_transmission_colour = 18u;
CRSH_CONST uint slot_specular_glossiness = 19u;
CRSH_CONST uint slot_count = 20u;

/// KHR metallic-roughness material with transmission, ior and thickness.
struct Material {
  vec4 base_colour;
  vec4 emissive_metallic;  ///< rgb: emissive factor times strength, cd/m2; w: metallic factor
  vec4 body;       ///< roughness, transmission, ior, thickness (object space metres; 0: thin-walled, does not bend)
  vec4 detail;     ///< normal scale, occlusion strength, alpha cutoff, unused
  uint slots;      ///< bits: which textures it has
  uint first_use;  ///< of the texture uses
  uint lobes;      ///< number of its Lobes; none: the metallic-roughness BRDF alone
  uint flags;
  uvec4 tint;  ///< xyz: -log2 of what one crossing lets through, 16.16 fixed point, saturated: opaque
};
CRSH_CONST uint material_unlit = 1u;                ///< KHR_materials_unlit: base colour is emitted, nothing reflected
CRSH_CONST uint material_mask = 2u;                 ///< alphaMode MASK
CRSH_CONST uint material_blend = 4u;                ///< alphaMode BLEND
CRSH_CONST uint material_specular_glossiness = 8u;  ///< KHR_materials_pbrSpecularGlossiness

/// What a material has beyond Material (KHR_materials_*); the lobes of the BSDF that few have.
struct Lobes {
  vec4 specular;              ///< rgb: specularColorFactor; w: specularFactor
  vec4 clearcoat;             ///< factor, roughness, normal scale; w: dispersion
  vec4 sheen;                 ///< rgb: colour; w: roughness
  vec4 iridescence;           ///< factor, ior, least and largest thickness in nanometres
  vec4 anisotropy;            ///< strength, cosine and sine of the rotation
  vec4 attenuation;           ///< rgb: -ln(attenuationColor) / attenuationDistance, 1/m
  vec4 diffuse_transmission;  ///< rgb: colour; w: factor
  vec4 glossiness;            ///< rgb: specular factor; w: glossiness factor
};

/// Of what a point of a surface has of them, in words of 16 bytes (lib/surface_lobes.glsl).
CRSH_CONST uint surface_lobe_words = 7u;
/// Specialisation constant of the kernels that keep or read these: whether the scene has any material with lobes.
CRSH_CONST uint constant_has_lobes = 20u;
CRSH_CONST uint constant_sheer_pages = 19u;  ///< of kernels that ask for alpha (lib/sheer.glsl)

CRSH_CONST uint light_point = 0u;
CRSH_CONST uint light_spot = 1u;
CRSH_CONST uint light_directional = 2u;

/// A light in world space (KHR_lights_punctual).
struct Light {
  vec4 position;   ///< xyz; w: type
  vec4 direction;  ///< xyz: the way it shines, unit; w: range in metres (infinite: no end)
  vec4 colour;     ///< rgb: colour times candela (point, spot) or lux (directional); w: 1: shines past backs
  vec4 cone;       ///< spot: x = scale, y = offset of the angular attenuation (KHR_lights_punctual)
};

CRSH_SHARED_END
#endif
