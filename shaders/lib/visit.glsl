#ifndef CRSH_LIB_VISIT_GLSL
#define CRSH_LIB_VISIT_GLSL
// One word says what a walk through the object hierarchy visits next: an inner node, by its index; a leaf, by the
// number of its triangles less 1 and the first of them; or `none`.

#include "shared/limits.h"
#include "shared/object.h"

const uint leaf_count_shift = 29u;
const uint leaf_first_mask = (1u << leaf_count_shift) - 1u;

/// The visit of a child, from its slot's `box_low.w` and `box_high.w`.
uint visit_of(float ref, float count) {
  uint visit = floatBitsToUint(ref), triangles = floatBitsToUint(count);
  uint leaf = visit | (triangles - 1u) << leaf_count_shift;
  return triangles == 0u ? none : (visit & child_is_leaf) != 0u ? leaf : visit;
}

bool is_inner(uint visit) { return (visit & child_is_leaf) == 0u; }

/// How many triangles a leaf has; 0 for `none` and for an inner node.
uint leaf_triangles(uint visit) {
  return visit == none || is_inner(visit) ? 0u : (visit >> leaf_count_shift & 3u) + 1u;
}

uint leaf_first(uint visit) { return visit & leaf_first_mask; }

#endif
