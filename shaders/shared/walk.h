#ifndef CRSH_SHARED_WALK_H
#define CRSH_SHARED_WALK_H
#include "shared/types.h"

CRSH_SHARED_BEGIN

// How ray nodes walk through the object hierarchy (shared/object.h). Groups, the nodes of level 2, find the small
// subtrees that their rays may hit, nearest first: this is their frontier. Level-1 nodes go on from there.
//
// A frontier is an array of frontier_room uvec2. The first one's x is the number of entries that follow. An entry's x
// is a child slot of the object hierarchy, its y has the bits of the distance before which no ray of the group is in
// that box.
CRSH_CONST uint frontier_room = 128u;

/// A subtree is small where it has no more triangles than this.
CRSH_CONST uint frontier_triangles = 16u;

CRSH_SHARED_END
#endif
