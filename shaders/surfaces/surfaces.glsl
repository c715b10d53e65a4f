// The buffers to which kernels write surfaces, bound from SURFACES_BINDING on in this order: those of
// surfaces::Surfaces in C++, with the emission of surfaces::Generation.

#include "lib/surface_lobes.glsl"

layout(binding = SURFACES_BINDING + 0, scalar) writeonly buffer Positions { vec4 out_position[]; };
layout(binding = SURFACES_BINDING + 1, scalar) writeonly buffer Normals { vec4 out_normal[]; };
layout(binding = SURFACES_BINDING + 2, scalar) writeonly buffer Geometrics { vec4 out_geometric[]; };
layout(binding = SURFACES_BINDING + 3, scalar) writeonly buffer Incomings { vec4 out_incoming[]; };
layout(binding = SURFACES_BINDING + 4, scalar) writeonly buffer Diffuses { vec4 out_diffuse[]; };
layout(binding = SURFACES_BINDING + 5, scalar) writeonly buffer Speculars { vec4 out_specular[]; };
layout(binding = SURFACES_BINDING + 6, scalar) writeonly buffer Emissions { vec4 out_emission[]; };
layout(binding = SURFACES_BINDING + 7, scalar) writeonly buffer Footprints { vec2 out_footprint[]; };
layout(binding = SURFACES_BINDING + 8, scalar) writeonly buffer SurfaceLobesOut { vec4 out_lobes[]; };

void store_lobes(uint i, SurfaceLobes lobes) {
  vec4 words[surface_lobe_words] = packed_lobes(lobes);
  for (uint w = 0u; w < surface_lobe_words; ++w) out_lobes[first_lobe_word(i) + w] = words[w];
}

void store_surface(uint i, uint triangle, Surface found, vec3 incoming, uint pixel, uint path, float f0_share,
                   float footprint) {
  out_position[i] = vec4(found.position, uintBitsToFloat(triangle));
  out_normal[i] = vec4(found.normal, found.transmission);
  out_geometric[i] = vec4(found.geometric, found.roughness);
  out_incoming[i] = vec4(incoming, found.eta);
  out_diffuse[i] = vec4(found.diffuse, uintBitsToFloat(pixel));
  out_specular[i] = vec4(found.specular, uintBitsToFloat(path));
  out_emission[i] = vec4(found.emission * found.alpha, f0_share);
  out_footprint[i] = vec2(footprint, found.alpha);
}

/// Writes a surface for where nothing was met: no rays start there.
void store_nothing(uint i, vec3 incoming, uint pixel, uint path) {
  out_position[i] = vec4(vec3(0.0), uintBitsToFloat(none));
  out_normal[i] = vec4(0.0);
  out_geometric[i] = vec4(0.0);
  out_incoming[i] = vec4(incoming, 1.0);
  out_diffuse[i] = vec4(vec3(0.0), uintBitsToFloat(pixel));
  out_specular[i] = vec4(vec3(0.0), uintBitsToFloat(path));
  out_emission[i] = vec4(vec3(0.0), -1.0);
  out_footprint[i] = vec2(0.0, 1.0);
  if (has_lobes) store_lobes(i, no_lobes(vec3(0.0, 0.0, 1.0), 0.0, 0.0));
}
