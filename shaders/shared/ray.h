#ifndef CRSH_SHARED_RAY_H
#define CRSH_SHARED_RAY_H
#include "shared/kinds.h"
#include "shared/types.h"

CRSH_SHARED_BEGIN

/// A ray; only 0 < t < tmax counts as hit. Metres.
struct Ray {
  vec4 origin;     ///< xyz: origin (a shadow ray's is the light's end), w: tmax (infinity for closest-hit rays)
  vec4 direction;  ///< xyz: unit direction, w: kind as a float
};

#ifndef __cplusplus
bool takes_any_hit(Ray ray) { return takes_any_hit(uint(ray.direction.w)); }
#endif

/// What the final intersection keeps for a ray.
/// Closest hit: x = bits of t (infinity: none), y = triangle id or `none`, z = 0.
/// Any hit: xyz = sum of -log2(transmittance) in 16.16 fixed point a channel, saturating at 0xFFFFFFFF (blocked).
/// w: how often alpha was asked for (alphaMode MASK and BLEND).
struct Hit {
  uvec4 words;
};

CRSH_SHARED_END
#endif
