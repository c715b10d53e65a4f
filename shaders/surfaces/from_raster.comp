#version 460
// The points to shade at k = 0: the raster pass's attachments (section 3.1) in the order in which rays are made.
// Lane: a pixel. Emission, the geometric normal and the side of a solid come from the triangle, as do lobes.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"
#include "lib/pixel_order.glsl"

layout(push_constant, scalar) uniform Push {
  vec3 eye;
  float orthographic;
  vec3 forward;
  uint tiles;  // 1: tiles, 0: scanlines
  uvec2 size;
  uint first;  // pixel of this order that becomes surface 0
  uint count;
  float cone_spread;  // how much wider a pixel's cone gets in a metre
  float cone_width;   // and how wide it is at the eye, metres
  uint sheets;        // 0: nothing shows behind what alphaMode BLEND leaves half there: it is drawn whole
};
layout(binding = 0, rgba32f) readonly uniform image2D positions;
layout(binding = 1, rgba32f) readonly uniform image2D normals;
layout(binding = 2, rgba32f) readonly uniform image2D diffuses;
layout(binding = 3, rgba32f) readonly uniform image2D speculars;
layout(binding = 4, r32ui) readonly uniform uimage2D ids;
#include "scene/lobes.glsl"
#define SURFACES_BINDING 5
#include "surfaces/surfaces.glsl"

/// Fills in, from the triangle, what the attachments do not have.
void complete(inout Surface found, uint triangle, Material material, vec3 incoming, float footprint) {
  Corners corners = corners_at(triangle);
  vec3 front = front_normal(corners.a, corners.b, corners.c);
  found.geometric = turned_normal(front, incoming);
  found.eta = eta_of(material, meets_front(front, incoming));
  found.emission = material.emissive_metallic.rgb;
  if ((material.slots & 1u << slot_emissive) != 0u) {
    vec3 weights = weights_at(found.position, corners.a, corners.b, corners.c);
    Point point =
        Point(triangle, found.position, weights, front, doubled_area(corners.a, corners.b, corners.c), footprint);
    found.emission *=
        texels_at(material, 1u << slot_emissive, attributes_at(triangle, weights), point, incoming).emissive.rgb;
  }
}

/// With lobes: the surface anew, as for a hit, with what they change of it.
Surface lobed_surface(uint i, uint triangle, Material material, vec3 position, vec3 incoming, float footprint) {
  Corners at = corners_at(triangle);
  vec3 weights = weights_at(position, at.a, at.b, at.c);
  Point point =
      Point(triangle, position, weights, front_normal(at.a, at.b, at.c), doubled_area(at.a, at.b, at.c), footprint);
  Attributes attributes = attributes_at(triangle, weights);
  Surface found = surface_of(material, attributes, point, incoming);
  store_lobes(i, lobes_of(material, attributes, point, incoming, found));
  return found;
}

void main() {
  uint i = invocation_index();
  if (i >= count) return;
  uvec2 pixel = tiles == 1u ? tiled_pixel(first + i, size) : scanline_pixel(first + i, size);
  ivec2 at = ivec2(pixel);
  uint number = pixel.y * size.x + pixel.x;
  uint id = imageLoad(ids, at).x;
  if (id == 0u) {
    store_nothing(i, forward, number, 1u);
    return;
  }
  vec4 position = imageLoad(positions, at), normal = imageLoad(normals, at);
  vec4 diffuse = imageLoad(diffuses, at);
  vec3 incoming = orthographic == 1.0 ? forward : exact_normalize(position.xyz - eye);
  Material material = material_of(id - 1u);
  Surface found;
  found.position = position.xyz;
  found.normal = normal.xyz;
  found.diffuse = diffuse.rgb;
  found.metallic = diffuse.w;
  vec4 specular = imageLoad(speculars, at);
  found.specular = specular.rgb;
  found.alpha = sheets == 1u ? specular.w : 1.0;
  found.roughness = position.w;
  found.transmission = normal.w;
  float footprint = cone_width + cone_spread * length(position.xyz - eye);
  complete(found, id - 1u, material, incoming, footprint);
  if (has_lobes && material.lobes != none) {
    float alpha = found.alpha;
    found = lobed_surface(i, id - 1u, material, position.xyz, incoming, footprint);
    found.alpha = alpha;
  } else if (has_lobes)
    store_lobes(i, no_lobes(found.normal, dielectric_share(material, found.metallic), found.metallic));
  store_surface(i, id - 1u, found, incoming, number, 1u, dielectric_share(material, found.metallic), footprint);
}
