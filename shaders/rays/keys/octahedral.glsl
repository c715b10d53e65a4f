// The direction on the octahedral map, 12 + 12 bits, interleaved.
#include "lib/cell.glsl"
#include "lib/morton.glsl"
#include "lib/octahedral.glsl"

layout(constant_id = 0) const uint shared_origin_key_bits = 24;
layout(constant_id = 1) const uint key_bits = 24;

uint ray_key(vec3 place, vec3 direction, bool shared_origin) { return morton(cell_of(octahedral(direction), 12)); }
