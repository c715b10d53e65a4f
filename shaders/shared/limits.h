#ifndef CRSH_SHARED_LIMITS_H
#define CRSH_SHARED_LIMITS_H
#include "shared/types.h"

CRSH_SHARED_BEGIN

/// No triangle, no ray, no child.
CRSH_CONST uint none = 0xFFFFFFFFu;
/// Triangles of one mask word of the top level's traversal.
CRSH_CONST uint block_triangles = 32u;
/// Most triangles of one batch: a lane walks a node's whole list in a loop, with two more loops of one turn each where
/// it hits, and lavapipe 22.3 ends loops silently after 65,535 iterations an invocation, all its loops together: a turn
/// for each of the three, and, where subgroups of four read together, two more for every four triangles.
CRSH_CONST uint max_batch_triangles = 12288u;
/// Most rays of one sorted batch (a 128 MiB binding of 32-byte rays).
CRSH_CONST uint max_batch_rays = 1u << 22;
/// Children that one lane looks through for where nodes are cut; a node ends at the end of such a run.
CRSH_CONST uint cut_run = 128u;
/// Most levels of nodes above the rays.
CRSH_CONST uint max_levels = 8u;

CRSH_SHARED_END
#endif
