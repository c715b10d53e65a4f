// The origin's place in the scene and the direction on the octahedral map, 5 bits a coordinate, all five interleaved.
#include "lib/cell.glsl"
#include "lib/morton.glsl"
#include "lib/octahedral.glsl"

layout(constant_id = 0) const uint shared_origin_key_bits = 25;
layout(constant_id = 1) const uint key_bits = 25;

uint ray_key(vec3 place, vec3 direction, bool shared_origin) {
  return morton(cell_of(place, 5), cell_of(octahedral(direction), 5), 5);
}
