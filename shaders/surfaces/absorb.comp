#version 460
// What solids take of the light that goes through them (KHR_materials_volume, Beer's law): the weights of one
// closest-hit kind's rays are multiplied by what is left behind the way to their hit; and what a ray meets inside a
// solid knows that. A ray that leaves the scene from inside is left as it is: such a mesh is not closed. Lane: a ray,
// in creation order.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"
#include "lib/surface_lobes.glsl"
#include "scene/tables.glsl"
#include "shared/ray.h"

layout(push_constant, scalar) uniform Push {
  uint first_ray;  // of the batch: it became surface `first_out`
  uint count;
  uint slots;         // a segment of the batch
  uint first_parent;  // surface of the batch's slot 0
  uint first_out;
};
layout(binding = 0, scalar) readonly buffer Slots { uint slot_of[]; };
layout(binding = 1, scalar) readonly buffer Hits { Hit hits[]; };
layout(binding = 2, scalar) buffer Weights { vec4 weights[]; };  // w: the solid that the ray travels in
layout(binding = 3, scalar) buffer SurfaceLobesOut { vec4 surface_lobes[]; };

void main() {
  uint i = invocation_index();
  if (i >= count) return;
  uint parent = first_parent + slot_of[first_ray + i] % slots;
  vec4 weight = weights[parent];
  uvec4 hit = hits[first_ray + i].words;
  float medium = floor(weight.w);
  if (medium <= 0.0 || hit.y == none) return;
  vec3 absorption = lobes_at(uint(medium) - 1u).attenuation.rgb;
  weights[parent].rgb = weight.rgb * exp(-absorption * uintBitsToFloat(hit.x));
  uint word = first_lobe_word(first_out + i) + lobe_word_of_medium;
  if (surface_lobes[word].w == 0.0) surface_lobes[word].w = medium;
}
