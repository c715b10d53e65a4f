#ifndef CRSH_INTERSECTION_NO_HIT_GLSL
#define CRSH_INTERSECTION_NO_HIT_GLSL

#include "shared/limits.h"
#include "shared/ray.h"

/// The hit of a ray that was not tested yet: t infinite and no triangle, or a transmittance of 1 (-log2 is 0).
uvec4 no_hit(Ray ray) { return takes_any_hit(ray) ? uvec4(0u) : uvec4(0x7F800000u, none, 0u, 0u); }

#endif
