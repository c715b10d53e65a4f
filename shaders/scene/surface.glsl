// The material at a point of a drawn triangle: one function, surface_of, for the raster pass and for the hits of every
// bounce.

#include "scene/tables.glsl"
#include "lib/surface.glsl"
#include "lib/textures.glsl"

/// Vertex attributes interpolated; the normal in world space, not yet unit.
struct Attributes {
  vec3 normal;
  vec4 colour;
  vec2 uv0;
  vec2 uv1;
};

vec3 normal_to_world(Instance instance, vec3 normal) {
  return vec3(dot(instance.normal0.xyz, normal), dot(instance.normal1.xyz, normal), dot(instance.normal2.xyz, normal));
}

/// Which stored vertices a drawn triangle's corners a, b, c are: a mirrored instance has swapped b and c.
uvec3 vertices_of(uint triangle, bool mirrored) {
  uvec3 corner = triangles[stored_of(triangle)].xyz;
  return mirrored ? corner.xzy : corner;
}

Attributes attributes_at(uint triangle, vec3 weights) {
  Instance instance = instances[instance_of(triangle)];
  uvec3 corner = vertices_of(triangle, instance.normal0.w != 0.0);
  Attributes sum = Attributes(vec3(0.0), vec4(0.0), vec2(0.0), vec2(0.0));
  for (int i = 0; i < 3; ++i) {
    Vertex vertex = vertices[corner[i]];
    sum.normal += vertex.normal * weights[i];
    sum.colour += unpackUnorm4x8(vertex.colour) * weights[i];
    sum.uv0 += vertex.uv0 * weights[i];
    sum.uv1 += vertex.uv1 * weights[i];
  }
  sum.normal = normal_to_world(instance, sum.normal);
  return sum;
}

/// What a material's textures hold at a point; white where it has none.
struct Texels {
  vec4 base_colour;
  vec4 metallic_roughness;
  vec4 emissive;
  vec4 transmission;
};

/// One loop over the textures that the material has: the sampler is long, and lavapipe 22.3 runs through every branch,
/// taken or not. (Nested loops that test at their ends give wrong sums there.)
Texels texels_at(Material material, Attributes at) {
  uvec4 words = material.textures;
  Texels found = Texels(vec4(1.0), vec4(1.0), vec4(1.0), vec4(1.0));
  uvec4 bits = mix(uvec4(1u, 2u, 4u, 8u), uvec4(0u), equal(words, uvec4(none)));
  uint left = bits.x | bits.y | bits.z | bits.w;
  if (left == 0u) return found;
  for (; left != 0u; left &= left - 1u) {
    int slot = findLSB(left);
    vec4 value = sample_texture(texture_of(words[slot] >> 1), (words[slot] & 1u) == 0u ? at.uv0 : at.uv1);
    if (slot == 0) found.base_colour = value;
    if (slot == 1) found.metallic_roughness = value;
    if (slot == 2) found.emissive = value;
    if (slot == 3) found.transmission = value;
  }
  return found;
}

/// The surface that a ray along the unit vector `incoming` meets at a point of a triangle with this material and front.
Surface surface_of(Material material, Attributes at, vec3 position, vec3 front, vec3 incoming) {
  Texels texels = texels_at(material, at);
  vec3 base = material.base_colour.rgb * at.colour.rgb * texels.base_colour.rgb;
  Surface found;
  found.position = position;
  found.geometric = turned_normal(front, incoming);
  found.normal = shading_normal(at.normal, found.geometric, incoming);
  found.metallic = clamp(material.emissive_metallic.w * texels.metallic_roughness.b, 0.0, 1.0);
  found.roughness = clamp(material.body.x * texels.metallic_roughness.g, 0.0, 1.0);
  found.transmission = clamp(material.body.y * texels.transmission.r, 0.0, 1.0);
  found.diffuse = base * (1.0 - found.metallic);
  found.specular = dielectric_share(material, found.metallic) + base * found.metallic;
  found.eta = eta_of(material, meets_front(front, incoming));
  found.emission = material.emissive_metallic.rgb * texels.emissive.rgb;
  return found;
}
