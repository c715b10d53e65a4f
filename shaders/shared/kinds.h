#ifndef CRSH_SHARED_KINDS_H
#define CRSH_SHARED_KINDS_H
#include "shared/types.h"

CRSH_SHARED_BEGIN

// What the rays of a kind are.
CRSH_CONST uint ray_any_hit = 1u;         ///< opaque hits block, others tint; else: the closest hit, a surface to shade
CRSH_CONST uint ray_a_light = 2u;         ///< one a surface and light; else: one a surface
CRSH_CONST uint ray_shared_origin = 4u;   ///< those of one light begin where it is: direction alone sorts them
CRSH_CONST uint ray_at_last_bounce = 8u;  ///< cast also from the last bounce's surfaces (k <= B); else: k < B
CRSH_CONST uint ray_at_first_bounce = 16u;  ///< cast only from what the camera sees (k = 0)
CRSH_CONST uint ray_adds_no_light = 32u;    ///< shown in a layer of its own only, and not cast unless asked for
CRSH_CONST uint ray_override = 64u;         ///< what --override-mirror makes of every surface
CRSH_CONST uint ray_goes_through = 128u;    ///< shows also what lies behind a surface that is not wholly there (BLEND)

/// The table of ray kinds, which shaders, command line, counters, panels, files and layers go by: ROW(name, number,
/// properties). Numbers rise from 0; the kind is the highest part of a sort key (section 3.2.2). A kind's rays are
/// created by shaders/rays/NAME.comp.
#define CRSH_RAY_KINDS(ROW)                                                           \
  ROW(shadow, 0u, ray_any_hit | ray_a_light | ray_shared_origin | ray_at_last_bounce) \
  ROW(reflection, 1u, ray_override)                                                   \
  ROW(refraction, 2u, ray_goes_through)

#define CRSH_ONE(name, number, properties) +1u
CRSH_CONST uint kind_count = 0u CRSH_RAY_KINDS(CRSH_ONE);
#undef CRSH_ONE

#define CRSH_ANY_HIT_BIT(name, number, properties) | ((ray_any_hit & (properties)) != 0u ? 1u << number : 0u)
CRSH_CONST uint any_hit_kinds = 0u CRSH_RAY_KINDS(CRSH_ANY_HIT_BIT);  ///< bit k: kind k
#undef CRSH_ANY_HIT_BIT

#define CRSH_CLOSEST_ONE(name, number, properties) +((ray_any_hit & (properties)) == 0u ? 1u : 0u)
CRSH_CONST uint closest_kind_count = 0u CRSH_RAY_KINDS(CRSH_CLOSEST_ONE);
#undef CRSH_CLOSEST_ONE

/// Bits of a path that say by which closest-hit kind a bounce was passed.
CRSH_CONST uint path_bits = closest_kind_count <= 2u ? 1u : closest_kind_count <= 4u ? 2u : 3u;

#ifdef __cplusplus
#define CRSH_NUMBER(name, number, properties) CRSH_CONST uint kind_##name = number;
CRSH_RAY_KINDS(CRSH_NUMBER)
#undef CRSH_NUMBER
#else
/// Whether rays of this kind are blocked and tinted by any hit; else they take the closest.
bool takes_any_hit(uint kind) { return (any_hit_kinds >> kind & 1u) != 0u; }
#endif

CRSH_SHARED_END
#endif
