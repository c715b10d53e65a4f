// What the shadow rays of a batch let through. The includer binds `ends` and `hits`.

#include "shared/limits.h"

/// The ray of a slot; `none` where it is empty.
uint ray_of(uint slot) {
  uint before = slot == 0u ? 0u : ends[slot - 1u];
  return ends[slot] > before ? before : none;
}

/// The transmittance of a ray, from its sum of -log2 in 16.16 fixed point; 0 where the sum is saturated: blocked.
vec3 let_through(uvec3 sum) {
  return mix(exp2(vec3(sum) * (-1.0 / 65536.0)), vec3(0.0), equal(sum, uvec3(0xFFFFFFFFu)));
}
