#ifndef CRSH_SHARED_COUNTERS_H
#define CRSH_SHARED_COUNTERS_H
#include "shared/limits.h"
#include "shared/types.h"

CRSH_SHARED_BEGIN

// A row of counters for each bounce and ray kind; 64 bits each, low word first.
CRSH_CONST uint counter_mesh_tests = 0u;
CRSH_CONST uint counter_triangle_tests = 1u;
CRSH_CONST uint counter_ray_hits = 2u;
CRSH_CONST uint counter_digest = 3u;
CRSH_CONST uint counter_box_tests = 4u;
CRSH_CONST uint counter_level_tests = 5u;                               ///< plus level - 1
CRSH_CONST uint counter_level_hits = counter_level_tests + max_levels;  ///< plus level - 1
CRSH_CONST uint counter_alpha_tests = counter_level_hits + max_levels;
CRSH_CONST uint counters_per_row = counter_alpha_tests + 1u;

CRSH_SHARED_END
#endif
