// The origin's place in the scene, 3 × 5 bits interleaved, then the direction on the octahedral map, 6 + 5 bits
// interleaved.
#include "lib/cell.glsl"
#include "lib/morton.glsl"
#include "lib/octahedral.glsl"

layout(constant_id = 0) const uint shared_origin_key_bits = 26;
layout(constant_id = 1) const uint key_bits = 26;

uint ray_key(vec3 place, vec3 direction, bool shared_origin) {
  return morton(cell_of(place, 5)) << 11 | morton(cell_of(octahedral(direction), 6)) >> 1;
}
