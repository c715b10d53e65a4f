#ifndef CRSH_SHARED_OBJECT_H
#define CRSH_SHARED_OBJECT_H
#include "shared/types.h"

CRSH_SHARED_BEGIN

// The object hierarchy: a binary tree of boxes over the drawn triangles, for the paper's "deeper BVH" (its future
// work).
//
// Node i has the child slots 2 i and 2 i + 1 of two buffers of vec4, box_low and box_high:
//   box_low.xyz, box_high.xyz  the child's box, padded (lib/box.glsl)
//   box_low.w                  bits: for a leaf `child_is_leaf` and the first of its triangles in leaf order, else an
//                              inner node's index
//   box_high.w                 bits: how many triangles the child holds in all; 0 in an empty slot
// Node 0 is the root. Triangles lie in leaf order in three buffers of vec4, leaf_a, leaf_b and leaf_c, so that every
// subtree's are neighbours. They are as in shared/scene.h, and leaf_c.w has the bits of the triangle's number.
CRSH_CONST uint child_is_leaf = 1u << 31;

/// Most triangles of a leaf.
CRSH_CONST uint max_leaf_triangles = 4u;
/// Most inner nodes on the way from the root to a leaf.
CRSH_CONST uint max_object_depth = 96u;

// The costs of a test for the surface area heuristic. A ray that meets a node is tested against two boxes.
CRSH_CONST float box_cost = 1.0f;
CRSH_CONST float triangle_cost = 1.0f;

CRSH_SHARED_END
#endif
