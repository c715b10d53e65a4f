// The paper's hashes (section 3.2.2). Figure 2, rays that share their origin, from a light: theta and phi of the
// direction, concatenated, 5 bits each. Figure 3, reflection and refraction rays: before them the origin's place in the
// scene, concatenated, 5 bits an axis. The paper does not say how many bits; 5 reproduce its Sponza.
#include "lib/cell.glsl"
#include "lib/spherical.glsl"

layout(constant_id = 0) const uint shared_origin_key_bits = 10;
layout(constant_id = 1) const uint key_bits = 25;

uint ray_key(vec3 place, vec3 direction, bool shared_origin) {
  const uvec2 angles = cell_of(spherical(direction), 5);
  const uvec3 origin = shared_origin ? uvec3(0) : cell_of(place, 5);
  return ((origin.x << 5 | origin.y) << 5 | origin.z) << 10 | angles.x << 5 | angles.y;
}
