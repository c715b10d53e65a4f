#ifndef CRSH_SHARED_ACCOUNT_H
#define CRSH_SHARED_ACCOUNT_H
#include "shared/types.h"

CRSH_SHARED_BEGIN

// What the account has by ray and by node; each makes a layer of the picture (Tests.triangle, Tests.node,
// Tests.object).
CRSH_CONST uint tests_triangle = 0u;  ///< exact tests of rays against triangles
CRSH_CONST uint tests_node = 1u;      ///< nodes against the bounds of triangles
CRSH_CONST uint tests_object = 2u;    ///< rays or nodes against bounds of objects, or boxes of a hierarchy over them
CRSH_CONST uint tests_count = 3u;

/// A pixel's tests are a 64-bit fixed-point number, low word first, with so many bits after the point. So sums are
/// exact, and do not depend on the order of adding.
CRSH_CONST uint tests_fraction_bits = 20u;

CRSH_SHARED_END
#endif
