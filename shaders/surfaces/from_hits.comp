#version 460
// The points to shade at k + 1: where the rays of one closest-hit kind of bounce k hit (section 3.2.6 feeds the next
// bounce). Lane: a ray, in creation order; it hands on its pixel, and its path with the turn that its kind is.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"
#include "lib/triangle.glsl"
#include "shared/ray.h"

layout(push_constant, scalar) uniform Push {
  uint first_ray;  // of the batch: it becomes surface `first_out`
  uint count;
  uint slots;         // a segment of the batch
  uint first_parent;  // surface of the batch's slot 0
  uint first_out;
  uint turn;          // which closest-hit kind it is
  float cone_spread;  // how much wider a pixel's cone gets in a metre
  uint sheets;        // 0: nothing shows behind what alphaMode BLEND leaves half there: it is drawn whole
};
layout(binding = 0, scalar) readonly buffer Rays { Ray rays[]; };
layout(binding = 1, scalar) readonly buffer Slots { uint slot_of[]; };
layout(binding = 2, scalar) readonly buffer Hits { Hit hits[]; };
layout(binding = 3, scalar) readonly buffer ParentDiffuses { vec4 parent_diffuse[]; };
layout(binding = 4, scalar) readonly buffer ParentSpeculars { vec4 parent_specular[]; };
layout(binding = 5, scalar) readonly buffer ParentFootprints { vec2 parent_footprint[]; };
#include "scene/lobes.glsl"
#define SURFACES_BINDING 6
#include "surfaces/surfaces.glsl"

void main() {
  uint i = invocation_index();
  if (i >= count) return;
  Ray ray = rays[first_ray + i];
  uint parent = first_parent + slot_of[first_ray + i] % slots;
  uint triangle = hits[first_ray + i].words.y;
  uint pixel = floatBitsToUint(parent_diffuse[parent].w);
  uint path = floatBitsToUint(parent_specular[parent].w) << path_bits | turn;
  if (triangle == none) {
    store_nothing(first_out + i, ray.direction.xyz, pixel, path);
    return;
  }
  float footprint = parent_footprint[parent].x + cone_spread * uintBitsToFloat(hits[first_ray + i].words.x);
  Corners at = corners_at(triangle);
  vec3 weights = barycentrics(ray.origin.xyz, ray.direction.xyz, at.a, at.b, at.c);
  Point point = Point(triangle, point_at(weights, at.a, at.b, at.c), weights, front_normal(at.a, at.b, at.c),
                      doubled_area(at.a, at.b, at.c), footprint);
  Material material = material_of(triangle);
  Attributes attributes = attributes_at(triangle, weights);
  Surface found = surface_of(material, attributes, point, ray.direction.xyz);
  if (sheets == 1u) found.alpha = abs(coverage_at(triangle, weights));
  if (has_lobes) store_lobes(first_out + i, lobes_of(material, attributes, point, ray.direction.xyz, found));
  store_surface(first_out + i, triangle, found, ray.direction.xyz, pixel, path,
                dielectric_share(material, found.metallic), footprint);
}
