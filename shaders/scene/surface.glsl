// The material at a point of a drawn triangle: one function for the raster pass and for the hits of every bounce.
// Needs SCENE_BINDING (scene/tables.glsl).

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

/// Which stored vertices the corners a, b, c are: a mirrored instance has swapped b and c.
uvec3 corners_of(Source source, bool mirrored) {
  uvec3 corner = triangles[source.triangle].xyz;
  return mirrored ? corner.xzy : corner;
}

Attributes attributes_at(uint triangle, vec3 weights) {
  Source source = sources[triangle];
  Instance instance = instances[source.instance];
  uvec3 corner = corners_of(source, instance.normal0.w != 0.0);
  Attributes sum = Attributes(vec3(0.0), vec4(0.0), vec2(0.0), vec2(0.0));
  for (int i = 0; i < 3; ++i) {
    Vertex vertex = vertices[corner[i]];
    sum.normal += vertex.normal * weights[i];
    sum.colour += unpackUnorm4x8(vertex.colour) * weights[i];
    sum.uv0 += vertex.uv0 * weights[i];
    sum.uv1 += vertex.uv1 * weights[i];
  }
  sum.normal = vec3(dot(instance.normal0.xyz, sum.normal), dot(instance.normal1.xyz, sum.normal),
                    dot(instance.normal2.xyz, sum.normal));
  return sum;
}

/// A material's texture at the attributes' coordinates; white where it has none.
vec4 texture_at(uint word, Attributes at) {
  if (word == none) return vec4(1.0);
  return sample_texture(textures[word >> 1], (word & 1u) == 0u ? at.uv0 : at.uv1);
}

vec3 emission_at(Material material, Attributes at) {
  return material.emissive_metallic.rgb * texture_at(material.emissive_texture, at).rgb;
}

/// The surface that a ray along the unit vector `incoming` meets.
Surface surface_at(uint triangle, vec3 weights, vec3 incoming) {
  vec3 a = corner_a[triangle].xyz, b = corner_b[triangle].xyz, c = corner_c[triangle].xyz;
  Attributes at = attributes_at(triangle, weights);
  Material material = material_of(triangle);
  vec3 front = front_normal(a, b, c);
  vec3 base = material.base_colour.rgb * at.colour.rgb * texture_at(material.base_colour_texture, at).rgb;
  vec4 metal_rough = texture_at(material.metallic_roughness_texture, at);

  Surface found;
  found.position = point_at(weights, a, b, c);
  found.geometric = turned_normal(front, incoming);
  found.normal = shading_normal(at.normal, found.geometric, incoming);
  found.metallic = clamp(material.emissive_metallic.w * metal_rough.b, 0.0, 1.0);
  found.roughness = clamp(material.roughness * metal_rough.g, 0.0, 1.0);
  found.transmission = clamp(material.transmission * texture_at(material.transmission_texture, at).r, 0.0, 1.0);
  found.diffuse = base * (1.0 - found.metallic);
  found.specular = dielectric_share(material, found.metallic) + base * found.metallic;
  found.eta = eta_of(material, meets_front(front, incoming));
  found.emission = emission_at(material, at);
  return found;
}
