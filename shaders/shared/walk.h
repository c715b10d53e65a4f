#ifndef CRSH_SHARED_WALK_H
#define CRSH_SHARED_WALK_H
#include "shared/types.h"

CRSH_SHARED_BEGIN

// A walk of ray nodes through the object hierarchy (shared/object.h). Groups, the nodes of level 2, find the small
// subtrees that their rays may meet, nearest first: their frontier. Level-1 nodes go on from there.
//
// A group owns frontier_room entries of uvec2. The first one's x is how many follow. An entry: x the child slot of the
// object hierarchy, y the bits of the distance before which no ray of the group is inside its box.
CRSH_CONST uint frontier_room = 128u;

/// A subtree of so many triangles, or fewer, is small.
CRSH_CONST uint frontier_triangles = 16u;

CRSH_SHARED_END
#endif
