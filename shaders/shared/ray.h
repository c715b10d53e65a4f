#ifndef CRSH_SHARED_RAY_H
#define CRSH_SHARED_RAY_H
#include "shared/kinds.h"
#include "shared/types.h"

CRSH_SHARED_BEGIN

CRSH_CONST float past_backs = 0.5f;  ///< of a ray that passes the backs of single-sided triangles, as the eye does

/// A ray; only 0 < t < tmax counts as hit. Metres.
struct Ray {
  vec4 origin;     ///< xyz: origin (a shadow ray's is the light's end), w: tmax (infinity for closest-hit rays)
  vec4 direction;  ///< xyz: unit direction, w: kind as a float; and past_backs, where an any-hit ray passes backs, too
};

#ifndef __cplusplus
bool takes_any_hit(Ray ray) { return takes_any_hit(uint(ray.direction.w)); }

/// Whether the back of a single-sided triangle is nothing to the ray.
bool passes_backs(Ray ray) { return !takes_any_hit(ray) || fract(ray.direction.w) != 0.0; }
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
