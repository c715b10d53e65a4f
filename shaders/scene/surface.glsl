// The material at a point of a drawn triangle: one function, surface_of, for the raster pass and for the hits of every
// bounce.

#include "scene/tables.glsl"
#include "lib/sheer.glsl"
#include "lib/surface.glsl"
#include "lib/tangent.glsl"
#include "lib/textures.glsl"

/// Vertex attributes interpolated; the normal in world space, not yet unit.
struct Attributes {
  vec3 normal;
  vec4 colour;
  vec2 uv[3];
};

vec4 colour_of(Vertex vertex) { return vec4(unpackHalf2x16(vertex.colour.x), unpackHalf2x16(vertex.colour.y)); }

vec3 normal_to_world(Instance instance, vec3 normal) {
  return vec3(dot(instance.normal0.xyz, normal), dot(instance.normal1.xyz, normal), dot(instance.normal2.xyz, normal));
}

vec3 direction_to_world(Instance instance, vec3 direction) {
  return vec3(dot(instance.row0.xyz, direction), dot(instance.row1.xyz, direction), dot(instance.row2.xyz, direction));
}

/// Which stored vertices a drawn triangle's corners a, b, c are: a mirrored instance has swapped b and c.
uvec3 vertices_of(uint triangle, bool mirrored) {
  uvec3 corner = stored_triangle(stored_of(triangle)).vertices;
  return mirrored ? corner.xzy : corner;
}

bool is_mirrored(Instance instance) { return instance.normal0.w != 0.0; }

Attributes attributes_at(uint triangle, vec3 weights) {
  Instance instance = instances[instance_of(triangle)];
  uvec3 corner = vertices_of(triangle, is_mirrored(instance));
  Attributes sum = Attributes(vec3(0.0), vec4(0.0), vec2[3](vec2(0.0), vec2(0.0), vec2(0.0)));
  for (int i = 0; i < 3; ++i) {
    Vertex vertex = vertex_at(corner[i]);
    sum.normal += vertex.normal * weights[i];
    sum.colour += colour_of(vertex) * weights[i];
    sum.uv[0] += vertex.uv[0] * weights[i];
    sum.uv[1] += vertex.uv[1] * weights[i];
    sum.uv[2] += vertex.uv[2] * weights[i];
  }
  sum.normal = normal_to_world(instance, sum.normal);
  return sum;
}

/// The point of a drawn triangle that is shaded.
struct Point {
  uint triangle;
  vec3 position;
  vec3 weights;     // barycentric
  vec3 front;       // unit normal of the triangle's front
  float area;       // twice the triangle's, m2
  float footprint;  // width, in metres, of what a pixel sees there, across the ray
};

/// Twice a triangle's area.
float doubled_area(vec3 a, vec3 b, vec3 c) { return length(cross(b - a, c - a)); }

/// What a ray cone that is so wide where it meets the surface covers of it along its longer axis. (Akenine-Moeller et
/// al., "Texture Level of Detail Strategies for Real-Time Ray Tracing", 2019; the cone is not bent by curvature.)
float footprint_on(Point point, vec3 incoming) {
  return point.footprint / max(abs(dot(point.front, incoming)), 0.0625);
}

/// Squared texels of `whole` a metre of a triangle, along the way in which they lie closest: the larger eigenvalue of J
/// transposed(J), J taking positions to texels. `metric`: of StoredTriangle, for the use's set of coordinates.
float texel_density(Texture whole, TextureUse use, uint metric, float area) {
  float unit = exp2(float(metric >> 24) - 135.0) / max(area, 1e-30);
  vec3 g = vec3(float(metric & 255u), float(metric >> 8 & 255u) - 128.0, float(metric >> 16 & 255u)) * unit;
  vec2 u = use.matrix.xy * float(whole.width), v = use.matrix.zw * float(whole.height);
  float uu = u.x * u.x * g.x + 2.0 * u.x * u.y * g.y + u.y * u.y * g.z;
  float uv = u.x * v.x * g.x + (u.x * v.y + u.y * v.x) * g.y + u.y * v.y * g.z;
  float vv = v.x * v.x * g.x + 2.0 * v.x * v.y * g.y + v.y * v.y * g.z;
  float half_difference = 0.5 * (uu - vv);
  return 0.5 * (uu + vv) + sqrt(half_difference * half_difference + uv * uv);
}

/// How many texels of the texture are as wide as `footprint` metres of the triangle.
float texels_across(Texture whole, TextureUse use, uvec3 uv_metrics, float area, float footprint) {
  return footprint * sqrt(max(texel_density(whole, use, uv_metrics[use.uv_set], area), 0.0));
}

/// Texture coordinates after KHR_texture_transform.
vec2 transformed(TextureUse use, vec2 uv) {
  precise vec2 x = use.matrix.xz * uv.x;
  precise vec2 y = use.matrix.yw * uv.y;
  precise vec2 sum = (x + y) + use.offset;
  return sum;
}

/// How a material uses the texture of one of its slots, which it must have.
TextureUse use_of(Material material, uint slot) {
  return texture_use(material.first_use + bitCount(material.slots & ((1u << slot) - 1u)));
}

/// Its value at a point.
vec4 texel_of(Material material, uint slot, Attributes at, uvec3 uv_metrics, float area, float footprint) {
  TextureUse use = use_of(material, slot);
  vec2 uv = use.uv_set == 0u ? at.uv[0] : use.uv_set == 1u ? at.uv[1] : at.uv[2];
  Texture whole = texture_of(use.texture);
  float texels = texels_across(whole, use, uv_metrics, area, footprint);
  return sample_texture(whole, use.texture, transformed(use, uv), texels);
}

/// What a material's textures hold at a point; white where it has none.
struct Texels {
  vec4 base_colour;
  vec4 metallic_roughness;
  vec4 emissive;
  vec4 transmission;
  vec4 normal;
};
const uint slots_of_all = (1u << slot_normal + 1u) - 1u;

/// One loop over the textures that the material has: the sampler is long, and lavapipe 22.3 runs through every branch,
/// taken or not. (Nested loops that test at their ends give wrong sums there.) `slots`: those of the first five that
/// are wanted.
Texels texels_at(Material material, uint slots, Attributes at, Point point, vec3 incoming) {
  Texels found = Texels(vec4(1.0), vec4(1.0), vec4(1.0), vec4(1.0), vec4(1.0));
  uint left = material.slots & slots;
  if (left == 0u) return found;
  uvec3 uv_metrics = stored_triangle(stored_of(point.triangle)).uv_metrics;
  float footprint = footprint_on(point, incoming);
  for (; left != 0u; left &= left - 1u) {
    uint slot = uint(findLSB(left));
    vec4 value = texel_of(material, slot, at, uv_metrics, point.area, footprint);
    if (slot == slot_base_colour) found.base_colour = value;
    if (slot == slot_metallic_roughness) found.metallic_roughness = value;
    if (slot == slot_emissive) found.emissive = value;
    if (slot == slot_transmission) found.transmission = value;
    if (slot == slot_normal) found.normal = value;
  }
  return found;
}

/// The frame of a point's tangents in world space; its tangent is 0 where the mesh has none. `normal`: as interpolated.
TangentFrame frame_at(Point point, vec3 normal) {
  Instance instance = instances[instance_of(point.triangle)];
  uvec3 corner = vertices_of(point.triangle, is_mirrored(instance));
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 3; ++i) {
    uint word = vertex_at(corner[i]).tangent;
    if (has_tangent(word)) sum += unpacked_tangent(word) * point.weights[i];
  }
  float sign = (sum.w < 0.0) != is_mirrored(instance) ? -1.0 : 1.0;
  vec3 straight = dot(normal, normal) > 0.0 ? exact_normalize(normal) : point.front;
  return tangent_frame(straight, exact_normalize(direction_to_world(instance, sum.xyz)), sign);
}

/// The frame of a texture's own axes: tangents are made from the coordinates before KHR_texture_transform, and a map
/// that is turned tilts the way it lies on the surface. `matrix`: TextureUse's. Its inverse takes (1, 0) to the way
/// that the texture's u goes; v goes down, the bitangent up.
TangentFrame turned_frame(TangentFrame frame, vec4 matrix) {
  float area = matrix.x * matrix.w - matrix.y * matrix.z;
  float side = area < 0.0 ? -1.0 : 1.0;
  vec2 along = vec2(matrix.w, matrix.z) * side;
  if (along.y == 0.0 && along.x > 0.0 && area > 0.0 || area == 0.0) return frame;
  vec3 tangent = exact_normalize(frame.tangent * along.x + frame.bitangent * along.y);
  vec3 across = cross(frame.normal, tangent);
  return TangentFrame(tangent, dot(cross(frame.normal, frame.tangent), frame.bitangent) * area < 0.0 ? -across : across,
                      frame.normal);
}

/// The shading normal where there is a normal map. `normal`: as interpolated; `matrix`: of the map's TextureUse.
vec3 tilted_normal(Point point, vec3 normal, vec3 geometric, vec3 texel, float scale, vec4 matrix, vec3 incoming) {
  TangentFrame frame = turned_frame(frame_at(point, normal), matrix);
  vec3 mapped = exact_normalize(mapped_normal(frame, texel, scale));
  if (!(dot(frame.tangent, frame.tangent) > 0.5 && dot(mapped, mapped) > 0.5))
    return shading_normal(normal, geometric, incoming);
  return lifted_normal(exact_dot(frame.normal, geometric) < 0.0 ? -mapped : mapped, incoming);
}

/// Of a triangle with alpha.
Sheer sheer_of(uint triangle) {
  int first = int(3u * stored_triangle(stored_of(triangle)).sheer);
  return sheer_of_words(texelFetch(sheers, first), texelFetch(sheers, first + 1), texelFetch(sheers, first + 2));
}

/// How much of a triangle is there, as every ray has it; negative: nothing, so that no ray meets it. What alphaMode
/// MASK leaves is there wholly.
float coverage_at(uint triangle, vec3 weights) {
  uint flags = flags_of(triangle);
  if (sheer_pages == 0u || (flags & triangle_sheer) == 0u) return 1.0;
  Sheer sheer = sheer_of(triangle);
  float alpha = alpha_at(sheer, weights, (flags & triangle_mirrored) != 0u);
  return !is_there(sheer, alpha) ? -1.0 : is_blended(sheer) ? alpha : 1.0;
}

/// The surface, wholly there, that a ray along the unit vector `incoming` meets at a point of a triangle with this
/// material.
Surface surface_of(Material material, Attributes at, Point point, vec3 incoming) {
  Texels texels = texels_at(material, slots_of_all, at, point, incoming);
  vec4 base = material.base_colour * at.colour * texels.base_colour;
  Surface found;
  found.position = point.position;
  found.geometric = turned_normal(point.front, incoming);
  found.normal = shading_normal(at.normal, found.geometric, incoming);
  if ((material.slots & 1u << slot_normal) != 0u)
    found.normal = tilted_normal(point, at.normal, found.geometric, texels.normal.xyz, material.detail.x,
                                 use_of(material, slot_normal).matrix, incoming);
  found.metallic = clamp(material.emissive_metallic.w * texels.metallic_roughness.b, 0.0, 1.0);
  found.roughness = clamp(material.body.x * texels.metallic_roughness.g, 0.0, 1.0);
  found.transmission = clamp(material.body.y * texels.transmission.r, 0.0, 1.0);
  found.diffuse = base.rgb * (1.0 - found.metallic);
  found.specular = dielectric_share(material, found.metallic) + base.rgb * found.metallic;
  found.eta = eta_of(material, meets_front(point.front, incoming));
  found.emission = material.emissive_metallic.rgb * texels.emissive.rgb;
  found.alpha = 1.0;
  return found;
}
