#pragma once
// Rays that were traced, judged by Embree, and by double precision where the two disagree.

#include <string>

#include "crsh/ray_table.h"
#include "oracle/embree.h"

namespace crsh::test {

struct Verdict {
  uint64_t rays = 0;
  uint64_t disagreed = 0;   ///< with Embree, which is right or wrong in float32 as well
  uint64_t exceptions = 0;  ///< right only within the margin: 1e-5, barycentric, of an edge, or 1e-5 t of the ray's end
                            ///< or of where alpha cuts the triangle away
  uint64_t wrong = 0;       ///< right in no way
  std::string first_wrong;  ///< a sentence
};

/// Whether every ray of the table met what it ought to among the triangles: hit or miss, its distance within 1e-5 t,
/// and what shadow rays let through.
[[nodiscard]] Verdict judged(const RayTable& rays, const std::vector<OracleTriangle>& triangles);

}  // namespace crsh::test
