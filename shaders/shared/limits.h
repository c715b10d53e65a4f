#ifndef CRSH_SHARED_LIMITS_H
#define CRSH_SHARED_LIMITS_H
#include "shared/types.h"

CRSH_SHARED_BEGIN

/// In place of an index: there is no triangle, ray or child.
CRSH_CONST uint none = 0xFFFFFFFFu;
/// How many triangles one mask word of the top level's traversal stands for.
CRSH_CONST uint block_triangles = 32u;
/// Most triangles that a lane walks in one dispatch. lavapipe 22.3 ends loops silently after 65,535 turns an
/// invocation, over all its loops. Each triangle takes three turns: one of the loop over the list, and one each of two
/// loops where it is hit. Where subgroups of four lanes read the list together, every four triangles take two more.
CRSH_CONST uint max_loop_triangles = 12288u;
/// Most rays of a batch: a binding of 128 MiB holds so many of 32 bytes.
CRSH_CONST uint max_batch_rays = 1u << 22;
/// Where nodes are cut, one lane goes through a run of so many children. A node ends at the end of a run, too.
CRSH_CONST uint cut_run = 128u;
/// Most levels of nodes above the rays.
CRSH_CONST uint max_levels = 8u;

CRSH_SHARED_END
#endif
